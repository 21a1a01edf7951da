#include "base/memory.hpp"

#include <gtest/gtest.h>

#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sphereview {

TEST(FreedMemory, OfLargeBlocksIsTheSystemsAgain) {
#ifdef __GLIBC__
    return_large_blocks();
    const auto mapped = [] { return mallinfo2().hblkhd; };
    const std::size_t before = mapped();
    for (int i = 0; i < 3; ++i) {  // glibc would keep the second, of a size that it has seen freed
        {
            const std::vector<char> block(std::size_t{16} << 20U, 'x');
            EXPECT_GE(mapped(), before + block.size()) << i;
        }
        EXPECT_EQ(mapped(), before) << i;
    }
#else
    GTEST_SKIP() << "nothing to be told to this allocator";
#endif
}

}  // namespace sphereview

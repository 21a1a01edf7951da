#include "base/freed_memory.hpp"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sphereview {

void return_large_blocks() {
#ifdef __GLIBC__
    constexpr int large = 4 << 20;  // bytes; smaller blocks are used again soon, and new pages cost time
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
#endif
}

}  // namespace sphereview

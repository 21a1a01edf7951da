#include "base/memory.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/temporary_folder.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(AvailableMemory, IsKnownOnLinux) {
#ifdef __linux__
    const auto available = available_memory();
    ASSERT_TRUE(available.has_value());
    EXPECT_GT(*available, 1'000'000U);
    EXPECT_LT(*available, std::uint64_t{1} << 50);
#endif
}

#ifdef __linux__

TEST(AvailableMemory, IsWhatTheTightestControlGroupLeaves) {
    const test::TemporaryFolder none;
    EXPECT_EQ(memory_left_in_groups(none.path()), std::nullopt);

    const test::TemporaryFolder folder;
    folder.write("proc/self/cgroup", "0::/outer/inner\n");
    const std::string outer = "sys/fs/cgroup/outer/";
    folder.write(outer + "memory.max", "7000\n");
    folder.write(outer + "memory.current", "6500\n");
    folder.write(outer + "memory.stat", "inactive_file 100\nactive_file 20\n");
    folder.write(outer + "inner/memory.max", "max\n");
    EXPECT_EQ(memory_left_in_groups(folder.path()), 620U);
}

#endif

TEST(AvailableMemory, IsAskedForInVainWithTheFigures) {
    if (!available_memory()) GTEST_SKIP() << "this system does not tell";
    const std::string message = message_of<MemoryError>([] { require_memory(std::uint64_t{1} << 60, "s.txt: they need"); });
    EXPECT_TRUE(message.starts_with("s.txt: they need 1152921504.6 GB of memory, ")) << message;
    EXPECT_TRUE(message.ends_with("B are available")) << message;
    EXPECT_NO_THROW(require_memory(1000, "it needs"));
    EXPECT_NO_THROW(require_memory(50'000'000, "it needs"));
}

TEST(AvailableMemory, IsWrittenForPeople) {
    EXPECT_EQ(in_bytes(0), "0 MB");
    EXPECT_EQ(in_bytes(3'600'000), "4 MB");
    EXPECT_EQ(in_bytes(999'000'000), "999 MB");
    EXPECT_EQ(in_bytes(80'040'000'000), "80.0 GB");
}

}  // namespace sphereview

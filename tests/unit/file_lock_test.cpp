#include "base/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "support/temporary_folder.hpp"

namespace sphereview {

TEST(FileLock, OfWhichNothingCanBeToldCountsAsHeld) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("lock", "");
    EXPECT_FALSE(FileLock::is_held(file));
    EXPECT_FALSE(FileLock::is_held(folder.path("missing")));
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{0, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    const bool held = FileLock::is_held(file);
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_TRUE(held) << "this process may open no file";
    EXPECT_TRUE(FileLock(file).holds());
    ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
    EXPECT_FALSE(FileLock(folder.path("fifo")).holds());
}

}  // namespace sphereview

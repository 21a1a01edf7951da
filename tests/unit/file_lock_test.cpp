#include "base/file_lock.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "support/temporary_folder.hpp"

namespace sphereview {

TEST(FileLock, HasAProcessANobodyOrNothingCanBeTold) {
    using Holder = FileLock::Holder;
    const test::TemporaryFolder folder;
    const std::string file = folder.write("lock", "");
    EXPECT_EQ(FileLock::holder_of(file), Holder::nobody);
    EXPECT_EQ(FileLock::holder_of(folder.path("missing")), Holder::nobody);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{0, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    const Holder holder = FileLock::holder_of(file);
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(holder, Holder::unknown) << "this process may open no file";
    const FileLock lock(file);
    EXPECT_TRUE(lock.holds());
    EXPECT_EQ(FileLock::holder_of(file), Holder::process);
    ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
    EXPECT_FALSE(FileLock(folder.path("fifo")).holds());
    EXPECT_EQ(FileLock::holder_of(folder.path("fifo")), Holder::unknown);
}

}  // namespace sphereview

#include "base/input_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <thread>

#include "base/error.hpp"
#include "support/temporary_folder.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(InputFile, ReadsEveryByte) {
    const test::TemporaryFolder folder;
    for (const std::string& bytes : {std::string(), std::string("a\0\r\n\x1a\xff", 6), std::string(1'000'000, 'x')}) {
        folder.write("in", bytes);
        const InputFile file(folder.path("in"));
        EXPECT_TRUE(file.bytes() == bytes) << bytes.size();
        EXPECT_EQ(file.name(), folder.path("in"));
    }
}

TEST(InputFile, ReadsAFileThatHidesItsSize) {
    const std::string path = "/proc/self/maps";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no /proc here";
    EXPECT_GT(InputFile(path).bytes().size(), 1000U);
}

TEST(InputFile, SaysThatAFileIsMissing) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path("none")); }),
              folder.path("none") + ": cannot be read: No such file or directory");
    EXPECT_EQ(message_of<InputError>([] { InputFile(""); }), ": cannot be read: No such file or directory");
}

TEST(InputFile, RefusesAFolder) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path()); }),
              folder.path() + ": cannot be read: it is a folder; expected a file");
}

TEST(InputFile, EndsWhereAnEndlessDeviceHoldsNoText) {
    const InputFile file("/dev/zero");
    EXPECT_EQ(file.bytes(), std::string_view("\0", 1));
    EXPECT_EQ(InputFile("/dev/null").bytes(), "");
}

TEST(InputFile, ReadsAPipeToItsEnd) {
    const test::TemporaryFolder folder;
    const std::string pipe = folder.path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string sent(300'000, 'x');  // more than a pipe holds at once, and than the first buffer
    std::thread writer([&] { folder.write("pipe", sent); });
    const InputFile file(pipe);
    writer.join();
    EXPECT_TRUE(file.bytes() == sent);
}

}  // namespace sphereview

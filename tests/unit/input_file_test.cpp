#include "base/input_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <thread>

#include "base/available_memory.hpp"
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

TEST(InputStream, ShowsTheFileThroughAWindow) {
    const test::TemporaryFolder folder;
    folder.write("in", "0123456789");
    InputStream stream(folder.path("in"));
    EXPECT_EQ(stream.size(), 10U);
    EXPECT_EQ(stream.bytes(), "");
    stream.fill(4);
    EXPECT_EQ(stream.bytes(), "0123");
    stream.drop_first(3);
    EXPECT_EQ(stream.bytes(), "3");
    stream.fill(4);
    EXPECT_EQ(stream.bytes(), "3456");
    stream.fill(2);
    EXPECT_EQ(stream.bytes(), "3456");
    EXPECT_FALSE(stream.ended());
    stream.drop_first(4);
    stream.fill(100);
    EXPECT_EQ(stream.bytes(), "789");
    EXPECT_TRUE(stream.ended());
}

TEST(InputStream, WidensItsWindowToTheEnd) {
    const test::TemporaryFolder folder;
    const std::string bytes(300'000, 'x');
    folder.write("in", bytes);
    InputStream stream(folder.path("in"));
    stream.fill(10);
    stream.drop_first(3);
    stream.fill();
    EXPECT_TRUE(stream.ended());
    EXPECT_TRUE(stream.bytes() == std::string_view(bytes).substr(3));
}

TEST(InputStream, IsRefusedAWindowThatCannotFit) {
    const test::TemporaryFolder folder;
    folder.write("in", "0123456789");
    InputStream stream(folder.path("in"));
    const std::size_t much = std::size_t{1} << 60;
    if (!available_memory()) GTEST_SKIP() << "this system does not tell";
    EXPECT_THROW(stream.fill(much), MemoryError);
}

}  // namespace sphereview

#include "base/input_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <thread>

#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/memory.hpp"
#include "support/gzip.hpp"
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

TEST(InputFile, RefusesAMissingFileAndAFolder) {
    const test::TemporaryFolder folder;
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path("none")); }),
              folder.path("none") + ": cannot be read: No such file or directory");
    folder.write("pep.pdb", "");
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path("pep.pbd")); }),
              folder.path("pep.pbd") + ": cannot be read: No such file or directory; did you mean 'pep.pdb'?");
    // Of a short name every other would be near: only the ending is looked at.
    folder.write("t.csv", "");
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path("t.cvs")); }),
              folder.path("t.cvs") + ": cannot be read: No such file or directory; did you mean 't.csv'?");
    EXPECT_EQ(message_of<InputError>([&] { InputFile(folder.path("u.csv")); }),
              folder.path("u.csv") + ": cannot be read: No such file or directory");
    EXPECT_EQ(message_of<InputError>([] { InputFile(""); }), ": cannot be read: No such file or directory");
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
    for (const std::string& bytes : {sent, test::gzipped(sent)}) {
        std::thread writer([&] { folder.write("pipe", bytes); });
        const InputFile file(pipe);
        writer.join();
        EXPECT_TRUE(file.bytes() == sent);
    }
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
    // To the end, from any place.
    const std::string bytes(300'000, 'x');
    InputStream large(folder.write("in", bytes));
    large.fill(10);
    large.drop_first(3);
    large.fill();
    EXPECT_TRUE(large.ended());
    EXPECT_TRUE(large.bytes() == std::string_view(bytes).substr(3));
}

TEST(InputStream, IsRefusedAWindowThatCannotFit) {
    const test::TemporaryFolder folder;
    folder.write("in", "0123456789");
    InputStream stream(folder.path("in"));
    const std::size_t much = std::size_t{1} << 60;
    if (!available_memory()) GTEST_SKIP() << "this system does not tell";
    EXPECT_THROW(stream.fill(much), MemoryError);
}

namespace {

using test::gzipped;

// Text that does not repeat, and packs to about half its size.
std::string varied_text(std::size_t size) {
    std::string text;
    for (std::uint64_t i = 1; text.size() < size; ++i) text += std::to_string(i * 0x9E3779B97F4A7C15U) + " ";
    text.resize(size);
    return text;
}

class Gunzipping : public testing::Test {
protected:
    // What a file of these bytes reads as.
    std::string read(std::string_view bytes) const {
        folder_.write("in.gz", bytes);
        return std::string(InputFile(folder_.path("in.gz")).bytes());
    }

    std::string fault_of(std::string_view bytes) const {
        const std::string message = message_of<InputError>([&] { read(bytes); });
        const std::string begin = folder_.path("in.gz") + ": cannot be unpacked: ";
        EXPECT_TRUE(message.starts_with(begin)) << message;
        return message.substr(begin.size());
    }

    test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(Gunzipping, GivesTheText) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{70'000}, std::size_t{3'000'000}}) {
        const std::string text = varied_text(size);
        EXPECT_TRUE(read(gzipped(text)) == text) << size;
    }
}

TEST_F(Gunzipping, GivesTheTextThroughAWindow) {
    const std::string text = varied_text(1'000'000);
    InputStream stream(folder_.write("in", gzipped(text)));  // the name does not matter
    EXPECT_EQ(stream.size(), std::nullopt);
    EXPECT_EQ(stream.name(), folder_.path("in"));
    std::string read;
    while (!stream.ended()) {
        stream.fill(1000);
        read += stream.bytes();
        stream.drop_first(stream.bytes().size());
    }
    EXPECT_TRUE(read == text);
}

TEST_F(Gunzipping, JoinsMembersAndSkipsPadding) {
    const std::string text = varied_text(300'000);
    EXPECT_TRUE(read(gzipped(text) + gzipped("") + gzipped("more")) == text + "more");
    EXPECT_EQ(read(gzipped("text") + std::string(10'000, '\0')), "text");
    EXPECT_EQ(read(gzipped("te") + std::string(512, '\0') + gzipped("xt")), "text");
}

TEST_F(Gunzipping, LeavesOtherFilesAsTheyAre) {
    for (const std::string bytes : {"", "\x1f", "\x1f\x8a", "1", "12", "\x8b\x1f", "text"}) EXPECT_EQ(read(bytes), bytes);
    folder_.write("in.gz", gzipped("text"));
    EXPECT_EQ(InputFile(folder_.path("in.gz"), Content::binary).bytes(), gzipped("text"));
    EXPECT_EQ(InputStream(folder_.path("in.gz"), Content::binary).size(), gzipped("text").size());
}

TEST_F(Gunzipping, RefusesWhatEndsTooEarly) {
    const std::string packed = gzipped(varied_text(1000));
    for (std::size_t size = 2; size < packed.size(); ++size) {
        ASSERT_EQ(fault_of(packed.substr(0, size)), "its gzip data end too early") << size;
    }
    EXPECT_EQ(fault_of(packed + packed.substr(0, 1)), "its gzip data end too early");
}

TEST_F(Gunzipping, RefusesDamage) {
    const std::string packed = gzipped(varied_text(1000));
    std::string bytes = packed;
    bytes[2] = 7;
    EXPECT_EQ(fault_of(bytes), "its gzip data are damaged (unknown compression method)");
    bytes = packed;
    bytes[bytes.size() - 5] ^= 1;
    EXPECT_EQ(fault_of(bytes), "its gzip data are damaged (incorrect data check)");
    bytes = packed;
    bytes[bytes.size() - 1] ^= 1;
    EXPECT_EQ(fault_of(bytes), "its gzip data are damaged (incorrect length check)");
    // The few unused bits behind the last code do not count.
    const std::size_t last_of_text = packed.size() - 10;
    for (std::size_t i = 10; i < last_of_text; ++i) {
        bytes = packed;
        bytes[i] ^= 0x10;
        ASSERT_THROW(read(bytes), InputError) << i;
    }
}

TEST_F(Gunzipping, RefusesOtherBytesBehindTheData) {
    const std::string wanted = "found other bytes behind its gzip data, expected its end";
    EXPECT_EQ(fault_of(gzipped("text") + "x"), wanted);
    EXPECT_EQ(fault_of(gzipped("text") + std::string(3, '\0') + "x"), wanted);
    EXPECT_EQ(fault_of(gzipped("text") + std::string(2 << 20, '\0')), wanted);
}

namespace {

// How many bytes can be read under the bounds, and what is wrong then.
std::pair<std::size_t, std::string> read_under(const ExpansionBounds& bounds, std::string packed) {
    const auto source = [&](char* to, std::size_t most) {
        const std::size_t count = std::min(most, packed.size());
        std::copy_n(packed.data(), count, to);
        packed.erase(0, count);
        return count;
    };
    Gunzip gunzip("bomb.gz", "", source, bounds);
    std::string room(1000, '\0');
    std::size_t size = 0;
    try {
        while (const std::size_t count = gunzip.read(room.data(), room.size())) size += count;
    } catch (const InputError& error) {
        return {size, error.what()};
    }
    return {size, ""};
}

}  // namespace

TEST(ExpansionBounds, AllowWhatIsSmall) {
    const std::string packed = gzipped(std::string(100'000, ' '));
    EXPECT_EQ(read_under({.small = 100'000, .ratio = 2, .most = 100'000}, packed), std::pair(std::size_t{100'000}, std::string()));
}

TEST(ExpansionBounds, StopAFileThatExpandsTooFar) {
    const std::string packed = gzipped(std::string(1'000'000, ' '));
    ASSERT_LT(packed.size(), 1'000'000U / 500);
    const auto [size, fault] = read_under({.small = 10'000, .ratio = 250, .most = 10'000'000}, packed);
    EXPECT_EQ(fault, "bomb.gz: cannot be unpacked: its text is longer than 250 times the file, as no scene's is");
    EXPECT_LE(size, 250 * packed.size() + 1000);
    EXPECT_EQ(read_under({.small = 10'000, .ratio = 1100, .most = 10'000'000}, packed).second, "");
}

TEST(ExpansionBounds, StopATextThatIsTooLong) {
    const auto [size, fault] = read_under({.small = 1000, .ratio = 1100, .most = 20'000}, gzipped(varied_text(30'000)));
    EXPECT_EQ(fault, "bomb.gz: cannot be unpacked: its text is longer than 20,000 bytes, more than is ever unpacked");
    EXPECT_EQ(size, 20'000U);
}

}  // namespace sphereview

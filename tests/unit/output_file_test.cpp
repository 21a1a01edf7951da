#include "base/output_file.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <thread>

#include "base/error.hpp"
#include "support/temporary_folder.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// The message that check_output and write_output both give.
std::string refusal(const std::string& path) {
    const std::string early = message_of<OutputError>([&] { check_output(path); });
    EXPECT_EQ(message_of<OutputError>([&] { write_output(path, "new"); }), early);
    return early;
}

}  // namespace

TEST(WriteOutput, MakesTheFileAndNothingElse) {
    const test::TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\n\xff", 7);
    write_output(folder.path("out.png"), bytes);
    EXPECT_EQ(folder.read("out.png"), bytes);
    write_output(folder.path("empty"), "");
    EXPECT_EQ(fs::file_size(folder.path("empty")), 0U);
    EXPECT_EQ(folder.names().size(), 2U);
}

TEST(WriteOutput, ReplacesAFileAndKeepsItsMode) {
    const test::TemporaryFolder folder;
    folder.write("out", "a much longer old content");
    fs::permissions(folder.path("out"), fs::perms{0640});
    write_output(folder.path("out"), "new");
    EXPECT_EQ(folder.read("out"), "new");
    EXPECT_EQ(fs::status(folder.path("out")).permissions(), fs::perms{0640});
    EXPECT_EQ(folder.names().size(), 1U);
}

TEST(WriteOutput, NeverShowsOthersWhatTheFileHidesFromThem) {
    const test::TemporaryFolder folder;
    folder.write("out", "old");
    fs::permissions(folder.path("out"), fs::perms{0600});
    const mode_t mask = umask(0);
    // Until the hidden file was seen, of larger and larger outputs.
    bool seen = false;
    for (std::size_t size = std::size_t{1} << 20; !seen && size <= std::size_t{1} << 28; size *= 2) {
        std::atomic<bool> ended = false;
        std::thread writing([&] {
            write_output(folder.path("out"), std::string(size, 'x'), Durability::in_system);
            ended = true;
        });
        while (!ended) {
            for (const std::string& name : folder.names()) {
                struct stat status {};
                if (name == "out" || stat(folder.path(name).c_str(), &status) != 0) continue;
                seen = true;
                EXPECT_EQ(status.st_mode & 0777U, 0600U);
            }
        }
        writing.join();
    }
    umask(mask);
    EXPECT_TRUE(seen);
}

TEST(WriteOutput, WaitsForAStandardOutputThatDoesNotBlock) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    fcntl(ends[1], F_SETFL, fcntl(ends[1], F_GETFL) | O_NONBLOCK);
    std::fflush(stdout);
    const int kept = dup(STDOUT_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[1]);
    const std::string bytes(std::size_t{1} << 20, 'x');  // more than a pipe holds
    std::string got;
    std::thread reader([&] {
        std::array<char, 4096> part{};
        for (ssize_t count = 0; (count = read(ends[0], part.data(), part.size())) > 0;)
            got.append(part.data(), static_cast<std::size_t>(count));
    });
    EXPECT_NO_THROW(write_output("-", bytes));
    dup2(kept, STDOUT_FILENO);
    close(kept);
    reader.join();
    close(ends[0]);
    EXPECT_TRUE(got == bytes) << got.size();
}

TEST(WriteOutput, TakesTheLongestFileName) {
    const test::TemporaryFolder folder;
    const std::string name(255, 'n');
    write_output(folder.path(name), "new");
    EXPECT_EQ(folder.read(name), "new");
}

TEST(WriteOutput, PartsHardLinks) {
    const test::TemporaryFolder folder;
    folder.write("a", "old");
    fs::create_hard_link(folder.path("a"), folder.path("b"));
    write_output(folder.path("a"), "new");
    EXPECT_EQ(folder.read("b"), "old");
}

TEST(WriteOutput, FollowsLinks) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path("far"));
    folder.write("far/real", "old");
    fs::create_symlink("far/second", folder.path("first"));
    fs::create_symlink("real", folder.path("far/second"));  // relative to its own folder
    write_output(folder.path("first"), "new");
    EXPECT_TRUE(fs::is_symlink(folder.path("first")));
    EXPECT_TRUE(fs::is_symlink(folder.path("far/second")));
    EXPECT_EQ(folder.read("far/real"), "new");
    EXPECT_EQ(folder.names().size(), 2U);
    fs::remove(folder.path("far/real"));  // then the links dangle
    write_output(folder.path("first"), "newer");
    EXPECT_TRUE(fs::is_symlink(folder.path("first")));
    EXPECT_EQ(folder.read("far/real"), "newer");
}

TEST(WriteOutput, RefusesWhatCannotBecomeAFile) {
    const test::TemporaryFolder folder;
    folder.write("file", "old");
    fs::create_symlink("loop", folder.path("loop"));
    fs::create_symlink("missing/file", folder.path("nowhere"));
    const std::string missing = folder.path("missing");
    EXPECT_EQ(refusal(folder.path()), folder.path() + ": cannot be written: it is a folder");
    EXPECT_EQ(refusal(missing + "/x"), missing + "/x: cannot be written: the folder " + missing + " does not exist");
    EXPECT_EQ(refusal(missing + "/"), missing + "/: cannot be written: it names a folder");
    EXPECT_EQ(refusal(folder.path("file/x")),
              folder.path("file/x: cannot be written: ") + folder.path("file") + " is not a folder");
    EXPECT_EQ(refusal(folder.path("nowhere")),
              folder.path("nowhere") + ": cannot be written: the folder " + missing + " does not exist");
    EXPECT_EQ(refusal(folder.path("loop")), folder.path("loop") + ": cannot be written: Too many levels of symbolic links");
    EXPECT_EQ(refusal(folder.path(std::string(256, 'n'))),
              folder.path(std::string(256, 'n')) + ": cannot be written: File name too long");
    EXPECT_EQ(refusal(""), "'': cannot be written: it has no name");
    EXPECT_EQ(folder.read("file"), "old");
    EXPECT_EQ(folder.names().size(), 3U);
}

TEST(WriteOutput, MakesTheFoldersThatAreWanted) {
    const test::TemporaryFolder folder;
    folder.write("file", "old");
    const auto write = [](const std::string& path) {
        check_output(path, MissingFolder::made);
        write_output(path, "new", Durability::on_disk, MissingFolder::made);
    };
    check_output(folder.path("a/b/c"), MissingFolder::made);
    EXPECT_EQ(folder.names().size(), 1U);  // so far nothing is made
    write(folder.path("a/b/c"));
    write(folder.path("a/b/d"));
    EXPECT_EQ(folder.read("a/b/c"), "new");
    EXPECT_EQ(folder.read("a/b/d"), "new");
    const std::string below = folder.path("file/x/y");
    EXPECT_EQ(message_of<OutputError>([&] { check_output(below, MissingFolder::made); }),
              below + ": cannot be written: " + folder.path("file") + " is not a folder");
}

TEST(OutputError, NamesTheFileAndHasErrno) {
    const test::TemporaryFolder folder;
    try {
        check_output(folder.path("missing/x"));
        FAIL();
    } catch (const OutputError& error) {
        EXPECT_EQ(error.fault.file, folder.path("missing/x"));
        EXPECT_EQ(error.fault.why, "cannot be written: the folder " + folder.path("missing") + " does not exist");
        EXPECT_EQ(error.fault.number, ENOENT);
    }
}

TEST(FileIdentity, IsOneForAllPathsToAFile) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder.path("sub"));
    folder.write("file", "");
    fs::create_symlink("file", folder.path("link"));
    fs::create_symlink("sub", folder.path("linked_folder"));
    fs::create_symlink("sub/new", folder.path("dangling"));
    const std::string file = file_identity(folder.path("file"), FileUse::output);
    EXPECT_NE(file, "");
    EXPECT_EQ(file_identity(folder.path("link"), FileUse::output), file);
    EXPECT_EQ(file_identity(folder.path("sub/../file"), FileUse::output), file);
    EXPECT_EQ(file_identity(folder.path("./file"), FileUse::output), file);
    EXPECT_EQ(file_identity(fs::relative(folder.path("file")).string(), FileUse::output), file);
    const std::string unmade = file_identity(folder.path("sub/new"), FileUse::output);
    EXPECT_EQ(file_identity(folder.path("dangling"), FileUse::output), unmade);
    EXPECT_EQ(file_identity(folder.path("linked_folder/new"), FileUse::output), unmade);
}

TEST(FileIdentity, DiffersForDifferentFiles) {
    const test::TemporaryFolder folder;
    folder.write("a", "");
    fs::create_hard_link(folder.path("a"), folder.path("b"));
    EXPECT_NE(file_identity(folder.path("a"), FileUse::output), file_identity(folder.path("b"), FileUse::output));
    EXPECT_NE(file_identity(folder.path("c"), FileUse::output), file_identity(folder.path("d"), FileUse::output));
}

TEST(RegularFile, IsWrittenAndNothingElse) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path("pipe")).c_str(), 0600), 0);
    for (const std::string& path : {folder.path("pipe"), std::string("/dev/null")}) {
        EXPECT_THROW(write_regular_file(path, "x"), OutputError) << path;
    }
    EXPECT_TRUE(fs::is_fifo(folder.path("pipe")));
    for (const char* bytes : {"new", "newer"}) {
        write_regular_file(folder.path("file"), bytes);
        EXPECT_EQ(folder.read("file"), bytes);
    }
}

TEST(FileIdentity, IsEmptyWhereNothingCanBeLost) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path("pipe")).c_str(), 0600), 0);
    EXPECT_EQ(file_identity("-", FileUse::output), "");
    EXPECT_EQ(file_identity("/dev/null", FileUse::output), "");
    EXPECT_EQ(file_identity(folder.path("pipe"), FileUse::output), "");
}

}  // namespace sphereview

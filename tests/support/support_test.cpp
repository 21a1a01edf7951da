// The tests' own tools, where a mistake would make other tests pass for nothing.
#include <gtest/gtest.h>

#include <csignal>

#include "support/picture.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview::test {
namespace {

Outcome shell(const std::string& script, Command command = {}) {
    command.program = "/bin/sh";
    command.arguments = {"-c", script};
    return run(command);
}

TEST(Picture, SurvivesAPng) {
    Picture picture = plain_picture(3, 2, {1, 2, 3, 0});
    picture.bytes[0] = '\xFF';
    picture.bytes[23] = '\x80';
    EXPECT_EQ(decode_png(encode_png(picture)), picture);
    EXPECT_EQ(picture.at(0, 0), (std::vector<int>{255, 2, 3, 0}));
    EXPECT_EQ(picture.at(2, 1), (std::vector<int>{1, 2, 3, 128}));
}

TEST(Program, ReportsStatusOutputAndErrors) {
    const Command command{.arguments = {}, .input = std::string(200'000, 'x')};  // more than a pipe holds
    const Outcome outcome = shell("cat; echo oops >&2; exit 7", command);
    EXPECT_EQ(outcome.status, 7);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.output, command.input);
    EXPECT_EQ(outcome.errors, "oops\n");
}

TEST(Program, ReportsTheSignalThatEndedIt) {
    const Outcome outcome = shell("kill -TERM $$");
    EXPECT_EQ(outcome.signal, 15);
    EXPECT_EQ(outcome.status, -1);
}

TEST(Program, GetsItsFolderItsEnvironmentAndATerminal) {
    const TemporaryFolder folder;
    const Command command{.arguments = {},
                          .folder = folder.path(),
                          .environment = {{"ADDED", "value"}, {"HOME", std::nullopt}},
                          .errors_to_terminal = true};
    EXPECT_EQ(shell("pwd; echo $ADDED-$HOME-; test -t 2 && echo terminal", command).output,
              folder.path() + "\nvalue--\nterminal\n");
}

TEST(Program, MeetsLimitsAndPermissions) {
    const TemporaryFolder folder;
    folder.write("protected", "");
    std::filesystem::permissions(folder.path("protected"), std::filesystem::perms::owner_read);
    Command command{.arguments = {}, .folder = folder.path(), .obeys_permissions = true};
    EXPECT_NE(shell("echo > protected", command).status, 0);
    EXPECT_NE(shell("exec 2>&-; echo > /dev/full").status, 0);
    command.largest_file = 4096;
    EXPECT_EQ(shell("exec head -c 10000 /dev/zero > file", command).signal, SIGXFSZ);
}

}  // namespace
}  // namespace sphereview::test

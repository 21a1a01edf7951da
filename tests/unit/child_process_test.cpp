#include "base/child_process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "support/environment.hpp"
#include "support/eventually.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using End = ChildResult::End;
using Group = ChildProcess::Group;

ChildResult shell(const std::string& script) { return ChildProcess("/bin/sh", {"-c", script}, Group::own).wait({}); }

bool is_running(const std::string& number) { return !number.empty() && kill(std::stoi(number), 0) == 0; }

std::string content(const std::string& path) {
    std::string text;
    std::ifstream(path) >> text;
    return text;
}

}  // namespace

TEST(ChildProcess, SaysWhatAProgramSaid) {
    const ChildResult result = shell("echo out; echo err >&2; cat; exit 7");
    EXPECT_EQ(result.end, End::exited);
    EXPECT_EQ(result.code, 7);
    EXPECT_EQ(result.output, "out\n");
    EXPECT_EQ(result.errors, "err\n");
    const ChildResult killed = shell("kill -SEGV $$");
    EXPECT_EQ(killed.end, End::killed_by_signal);
    EXPECT_EQ(killed.code, SIGSEGV);
}

TEST(ChildProcess, PassesArgumentsAsTheyAre) {
    const ChildResult result = ChildProcess("/bin/echo", {"a  b", "$HOME", "'\"`;*"}, Group::ours).wait({});
    EXPECT_EQ(result.output, "a  b $HOME '\"`;*\n");
}

TEST(ChildProcess, SaysWhyNothingStarted) {
    const ChildResult result = ChildProcess("/missing/program", {}, Group::ours).wait({});
    EXPECT_EQ(result.end, End::not_started);
    EXPECT_EQ(result.errors, "No such file or directory");
}

TEST(ChildProcess, EndsAtTheDeadline) {
    ChildProcess child("/bin/sh", {"-c", "echo begun; sleep 1000"}, Group::own);
    const ChildResult result = child.wait(std::chrono::steady_clock::now() + std::chrono::milliseconds(300));
    EXPECT_EQ(result.end, End::timed_out);
}

TEST(ChildProcess, EndsWithWhatItHasStartedWhenItIsKilled) {
    const test::TemporaryFolder folder;
    ChildProcess child("/bin/sh", {"-c", "sleep 1000 & echo $! > '" + folder.path("number") + "'; wait"}, Group::own);
    ASSERT_TRUE(test::eventually([&] { return !content(folder.path("number")).empty(); }));
    const std::string number = content(folder.path("number"));
    std::thread killer([&] { child.kill(); });
    const ChildResult result = child.wait({});
    killer.join();
    EXPECT_EQ(result.end, End::killed_by_signal);
    EXPECT_EQ(result.code, SIGKILL);
    // Whoever takes in orphans may leave it as a zombie.
    EXPECT_TRUE(test::eventually([&] { return !is_running(number) || content("/proc/" + number + "/cmdline").empty(); }));
}

TEST(ChildProcess, HasEndedThoughWhatItStartedKeepsItsOutput) {
    const ChildResult result = ChildProcess("/bin/sh", {"-c", "sleep 20 & echo done"}, Group::own).wait({});
    EXPECT_EQ(result.end, End::exited);
    EXPECT_EQ(result.output, "done\n");
}

TEST(ChildProcess, IsKilledWhenNobodyWaits) {
    const auto begin = std::chrono::steady_clock::now();
    { const ChildProcess child("/bin/sleep", {"1000"}, Group::ours); }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(100));
}

TEST(FindProgram, LooksWhereAShellWould) {
    const test::TemporaryFolder folder;
    fs::permissions(folder.write("second/tool", "#!/bin/sh\n"), fs::perms::owner_all);
    folder.write("first/tool", "not executable");
    fs::create_directories(folder.path("third/other"));
    const test::Variable path("PATH",
                              "relative::" + folder.path("first") + ":" + folder.path("second") + ":" + folder.path("third"));
    EXPECT_EQ(find_program("tool"), folder.path("second/tool"));
    EXPECT_EQ(find_program("other"), "") << "a folder";
    EXPECT_EQ(find_program("missing"), "");
}

}  // namespace sphereview

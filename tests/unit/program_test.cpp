// Other programs, started by this one.
#include "base/program.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "base/error.hpp"
#include "support/no_threads.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using End = ProgramResult::End;

ProgramResult shell(const std::string& command, std::chrono::milliseconds limit = std::chrono::minutes(5)) {
    return run_program("/bin/sh", {"-c", command}, limit);
}

}  // namespace

TEST(RunProgram, GivesWhatWasWritten) {
    // More than a pipe holds.
    const ProgramResult result = shell("head -c 300000 /dev/zero | tr '\\0' x; echo one >&2; echo two >&2");
    EXPECT_EQ(result.end, End::returned);
    EXPECT_EQ(result.output, std::string(300'000, 'x'));
    EXPECT_EQ(result.errors, "one\ntwo\n");
}

TEST(RunProgram, SaysHowElseItEnded) {
    const ProgramResult crashed = shell("kill -ABRT $$");
    EXPECT_EQ(crashed.end, End::crashed);
    EXPECT_EQ(crashed.code, static_cast<unsigned>(SIGABRT));
    const ProgramResult ended = shell("echo half; exit 7");
    EXPECT_EQ(ended.end, End::exited);
    EXPECT_EQ(ended.code, 7U);
    EXPECT_EQ(shell("exit 0").end, End::exited);
    EXPECT_THROW(run_program("/none", {}, std::chrono::minutes(5)), OutputError);
}

TEST(RunProgram, EndsAtTheLimit) {
    const ProgramResult result = shell("echo begun >&2; sleep 3600", std::chrono::seconds(2));
    EXPECT_EQ(result.end, End::timed_out);
    EXPECT_EQ(result.errors, "begun\n");
}

// What it has started may live on, and hold the pipes open.
TEST(RunProgram, DoesNotWaitForWhatTheProgramHasStarted) {
    const ProgramResult result = shell("sleep 60 & echo done");
    EXPECT_EQ(result.end, End::returned);
    EXPECT_EQ(result.output, "done\n");
}

namespace {

// While it lives no file can be opened, neither by Clang's sanitizer, which looks at an exception so before it is asked what it
// says.
struct NoFiles {
    NoFiles() {
        getrlimit(RLIMIT_NOFILE, &usual);
        const rlimit none{0, usual.rlim_max};
        setrlimit(RLIMIT_NOFILE, &none);
    }
    ~NoFiles() { setrlimit(RLIMIT_NOFILE, &usual); }

    rlimit usual{};
};

}  // namespace

TEST(PipedProgram, SaysThatThereAreTooManyOpenFiles) {
    const std::string said = message_of<OutputError>([] {
        const NoFiles none;
        const PipedProgram program("/bin/sh", {"-c", "exit"});
    });
    EXPECT_TRUE(said.ends_with(std::strerror(EMFILE))) << said;
}

// Who is told so may remove what it would write.
TEST(PipedProgram, IsGoneWhereNothingCanReadWhatItSays) {
    if (!test::NoThreads::possible) GTEST_SKIP() << "threads can always begin here";
    const test::NoThreads none;
    const std::string said = message_of<OutputError>([] { const PipedProgram program("/bin/sh", {"-c", "exec sleep 60"}); });
    EXPECT_TRUE(said.ends_with("the system allows no more threads")) << said;
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "there is no child";
}

}  // namespace sphereview

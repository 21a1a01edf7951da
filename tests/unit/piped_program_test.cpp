// Programs that cannot be started, and what is left of them.
#include "base/piped_program.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "support/no_threads.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(PipedProgram, SaysThatThereAreTooManyOpenFiles) {
    rlimit usual{};
    getrlimit(RLIMIT_NOFILE, &usual);
    const rlimit none{0, usual.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    const std::string said = message_of<OutputError>([] { const PipedProgram program("/bin/sh", {"-c", "exit"}); });
    setrlimit(RLIMIT_NOFILE, &usual);
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

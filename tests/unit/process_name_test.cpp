#include "base/process_name.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace sphereview {

TEST(ProcessName, IsOfAProcessThatRuns) {
    EXPECT_EQ(process_name(), process_name());
    EXPECT_TRUE(process_runs(process_name()));
    for (const char* none : {"", "-", "x", "0", "-1", "1x", "999999999999999999999", "2147483646-5"})
        EXPECT_FALSE(process_runs(none));
}

TEST(ProcessName, IsOfNoProcessAfterItsEnd) {
    int ends[2] = {};
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        const std::string name = process_name() + "\n";
        [[maybe_unused]] const auto written = write(ends[1], name.data(), name.size());
        pause();
        _exit(0);
    }
    std::string name;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) name += c;
    EXPECT_NE(name, process_name());
    EXPECT_TRUE(process_runs(name));
#ifdef __linux__
    EXPECT_FALSE(process_runs(name + "1")) << "another process with the same number";
#endif
    kill(child, SIGKILL);
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
#ifdef __linux__
    EXPECT_FALSE(process_runs(name)) << "ended, though not waited for";
#endif
    waitpid(child, nullptr, 0);
    EXPECT_FALSE(process_runs(name));
    close(ends[0]);
    close(ends[1]);
}

}  // namespace sphereview

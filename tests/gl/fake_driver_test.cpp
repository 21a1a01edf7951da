// Drivers that hang, crash, end the program or are not what they are called.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "support/json.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// A command that finds libraries in `folder` first.
Command with_libraries(const std::string& folder, const std::vector<std::string>& arguments) {
    Command command{.arguments = arguments, .environment = {{"LD_LIBRARY_PATH", folder}}};
    // A sanitized program would turn a crash into an exit.
    const char* options = std::getenv("ASAN_OPTIONS");
    command.environment.emplace_back("ASAN_OPTIONS", (options != nullptr ? std::string(options) + ":" : "") + "handle_segv=0");
    return command;
}

std::string fake(const std::string& name) { return FAKE_DRIVERS "/" + name; }

// What doctor says of the backend of that name; the first where there are several.
Json row_of(const Json& report, const std::string& backend) {
    for (const Json& row : report["backends"]) {
        if (row["backend"] == backend) return row;
    }
    return {};
}

// Runs doctor against a fake EGL and returns its row; the CPU must work and the exit status be 0.
Json egl_row(const std::string& driver, const std::string& timeout) {
    const Outcome outcome = run(with_libraries(fake(driver), {"doctor", "--json", "--timeout", timeout}));
    EXPECT_EQ(outcome.status, 0) << outcome;
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(row_of(report, "cpu")["works"], true);
    const Json row = row_of(report, "egl");
    EXPECT_EQ(row["works"], false);
    EXPECT_FALSE(row["advice"].get<std::string>().empty());
    return row;
}

TEST(FakeDriver, ThatHangsIsARowOfDoctor) {
    // The limit holds for the CPU's probe too, which needs milliseconds.
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(contains(egl_row("hanging_egl", "5")["reason"].get<std::string>(), "the driver gave no answer within 5 s"));
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(FakeDriver, ThatHangsEndsWithTheDoctorThatIsKilled) {
    const TemporaryFolder folder;
    const std::string fifo = folder.path("alive");
    ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
    for (const int signal_number : {SIGTERM, SIGKILL}) {
        Command command = with_libraries(fake("hanging_egl"), {"doctor", "--timeout", "600"});
        command.environment.emplace_back("SPHEREVIEW_TEST_FIFO", fifo);
        Running doctor(command);
        const int alive = open(fifo.c_str(), O_RDONLY);
        pid_t child = 0;
        ASSERT_EQ(read(alive, &child, sizeof child), static_cast<ssize_t>(sizeof child));
        doctor.send(signal_number);
        doctor.wait();
        pollfd end{alive, POLLIN, 0};
        const bool ended = poll(&end, 1, 10'000) == 1;
        EXPECT_TRUE(ended) << "after signal " << signal_number;
        if (!ended) kill(child, SIGKILL);
        close(alive);
    }
}

TEST(FakeDriver, ThatIsOnlySlowIsNotSaidToHang) {
    const Outcome outcome = run({"doctor", "--json", "--timeout", "0.0001"});
    EXPECT_EQ(outcome.status, 3) << outcome;
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(row_of(report, "cpu")["reason"], "the CPU renderer gave no answer within 1e-04 s");
    EXPECT_EQ(row_of(report, "cpu")["advice"], "allow it more time with --timeout");
    EXPECT_EQ(row_of(report, "osmesa")["reason"], "the driver gave no answer within 1e-04 s");
}

TEST(FakeDriver, ThatCrashesEndsTheProgramOrLacksFunctionsIsARowOfDoctor) {
    for (const auto& [driver, said] : {std::pair{"crashing_egl", "the driver crashed (signal 11)"},
                                       {"exiting_egl", "the driver ended the program (status 7)"},
                                       {"bare", "libEGL lacks functions"}}) {
        EXPECT_TRUE(contains(egl_row(driver, "60")["reason"].get<std::string>(), said));
    }
    const Outcome words = run(with_libraries(fake("bare"), {"doctor"}));
    EXPECT_EQ(words.status, 0) << words;
    EXPECT_TRUE(contains(words.output, "EGL: does not work\n    why:       libEGL lacks functions"));
    EXPECT_TRUE(contains(words.output, "OSMesa: does not work\n    why:       libOSMesa lacks functions"));
    EXPECT_TRUE(contains(words.output, "CPU: works"));
}

}  // namespace
}  // namespace sphereview::test

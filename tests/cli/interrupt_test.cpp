// Work that takes long: the progress bar, and an interruption, which leaves nothing behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "support/render.hpp"
#include "support/text_match.hpp"
#include "support/trials.hpp"

namespace sphereview::test {
namespace {

using Names = std::vector<std::string>;

class Interrupt : public testing::TestWithParam<std::pair<int, int>> {
protected:
    Interrupt() { mkfifo(folder_.path("scene").c_str(), 0600); }

    TemporaryFolder folder_;
};

// Opening a FIFO waits until the program opens it too: from then on it runs and handles signals.
TEST_P(Interrupt, WhileReadingOrRenderingLeavesNothing) {
    const auto [signal_number, status] = GetParam();
    for (const bool whole_scene : {false, true}) {
        folder_.write("old.png", "old");
        Running program(cpu_render(folder_, {"scene", "-s", endless_size, "-o", "old.png"}));
        std::ofstream scene(folder_.path("scene"));
        scene << endless_scene();
        if (whole_scene) scene.close();  // now it renders, or is about to
        program.send(signal_number);
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.status, status) << outcome;
        EXPECT_EQ(outcome.output + outcome.errors, "");
        EXPECT_EQ(folder_.names(), (Names{"old.png", "scene"}));
        EXPECT_EQ(folder_.read("old.png"), "old");
    }
}

// The window keeps unsaved changes when it is interrupted; before it is open there are none, and reading may never end.
TEST_P(Interrupt, BeforeTheWindowIsOpenEndsTheProgram) {
    const auto [signal_number, status] = GetParam();
    Running program({.arguments = {"scene"},
                     .folder = folder_.path(),
                     .environment = {{"HOME", folder_.path()}, {"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}}});
    const std::ofstream scene(folder_.path("scene"));
    program.send(signal_number);
    EXPECT_EQ(program.wait().status, status);
}

// Interrupted at each system call from the end of its input to its own end, the program leaves the whole file or nothing.
TEST(Interruption, AtAnySystemCallLeavesAllOrNothing) {
    const TemporaryFolder folder;
    const Command command{.arguments = {"convert", "-", "new.txt", "--to", "text"},
                          .folder = folder.path(),
                          .input = red_scene,
                          .input_stays_open = true,
                          .environment = {{"LSAN_OPTIONS", "detect_leaks=0"}}};  // it, too, would want to trace the program
    constexpr int step = 4 / trials(4);  // with sanitizers there are four times as many calls, most of them theirs
    bool met_a_hidden_file = false;
    for (int calls = 0;; calls += step) {
        SCOPED_TRACE(calls);
        folder.write("new.txt", "old");
        Running program(command);
        const bool stopped = program.stop_after_system_calls(calls);
        met_a_hidden_file = met_a_hidden_file || folder.names().size() > 1;
        if (stopped) program.resume_with(SIGTERM);
        const Outcome outcome = program.wait();
        const std::string content = folder.read("new.txt");
        ASSERT_EQ(folder.names(), Names{"new.txt"}) << outcome;
        ASSERT_TRUE(content == "old" || content == red_scene) << content;
        if (!stopped) {
            EXPECT_EQ(outcome.status, 0) << outcome;
            EXPECT_EQ(content, red_scene);
            break;
        }
        // A signal during the very last call, exit itself, comes too late.
        ASSERT_TRUE(outcome.status == 143 || (outcome.status == 0 && content == red_scene)) << outcome;
    }
    EXPECT_TRUE(met_a_hidden_file);  // or nothing was tested
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt,
                         testing::Values(std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)),
                         [](const auto& signal) { return "Status" + std::to_string(signal.param.second); });

TEST(InterruptOfABackgroundJob, IsStillIgnored) {
    const TemporaryFolder folder;
    Command command = cpu_render(folder, {"-", "-s", "5x5"});
    command.ignores_interrupts = true;
    command.input_stays_open = true;
    command.input = red_scene;
    Running program(command);
    program.send(SIGINT);
    program.close_input();
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(folder.has("stdin.png"));
}

// The same work twice: when the terminal's bar was drawn, it was time for the other's, too. The test ends both.
TEST(ProgressBar, IsShownOnATerminalAloneWhenTheWorkIsLong) {
    const TemporaryFolder folder;
    folder.write("endless.txt", endless_scene());
    Command command = cpu_render(folder, {"endless.txt", "-s", endless_size});
    Running silent(command);
    command.errors_to_terminal = true;
    Running shown(command);
    EXPECT_TRUE(shown.wait_for_errors("s left  endless", 3));
    shown.send(SIGTERM);
    silent.send(SIGTERM);
    const Outcome terminal = shown.wait();
    EXPECT_TRUE(terminal.errors.starts_with("\r\x1b[K[")) << testing::PrintToString(terminal.errors);
    EXPECT_TRUE(contains(terminal.errors, " Mpixel/s, "));
    EXPECT_EQ(terminal.output, "");
    const Outcome file = silent.wait();
    EXPECT_EQ(file.status, 143) << file;
    EXPECT_EQ(file.output + file.errors, "");
}

TEST(ProgressBar, CountsPixelsThatAreDecidedExactlyAndGoesAtOnce) {
    const TemporaryFolder folder;
    folder.write("endless.txt", endless_scene());
    Command command = cpu_render(folder, {"endless.txt", "-s", endless_size});
    command.errors_to_terminal = true;
    Running program(command);
    EXPECT_TRUE(program.wait_for_errors(" exactly, "));
    const auto begin = std::chrono::steady_clock::now();
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome;
    EXPECT_TRUE(outcome.errors.ends_with("\r\x1b[K")) << testing::PrintToString(outcome.errors);
    // A tenth of that on a machine that does nothing else.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
    EXPECT_EQ(folder.names(), Names{"endless.txt"});
}

// A file that comes in slowly: a FIFO, fed by the test.
TEST(ProgressBar, IsShownWhileALongTextIsRead) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo(folder.path("slow").c_str(), 0600), 0);
    Command command = cpu_render(folder, {"slow", "-s", "5x5"});
    command.errors_to_terminal = true;
    Running program(command);
    std::ofstream slow(folder.path("slow"));
    slow << "1000000\n";
    const auto feed = [&] {
        for (int i = 0; i < 400'000; ++i) slow << "1 2 3 4.5 5.5 6.5 7\n";  // 8 MB
        slow.flush();
    };
    feed();
    std::this_thread::sleep_for(std::chrono::milliseconds(700));  // more than the bar's patience
    feed();
    EXPECT_TRUE(program.wait_for_errors(" s left  slow"));
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().status, 143);
}

TEST(ProgressBar, IsNotShownWhenTheWorkIsShort) {
    const TemporaryFolder folder;
    Command command = cpu_render(folder, {"-", "-s", "5x5"});
    command.input = red_scene;
    command.errors_to_terminal = true;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
}

}  // namespace
}  // namespace sphereview::test

// The progress bar: for people who wait at a terminal, and for nobody else.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Work that lasts longer than the bar's patience on any machine: it is ended by the test.
Command endless_render(const TemporaryFolder& folder) {
    folder.write("endless.txt", endless_scene());
    return cpu_render(folder, {"endless.txt", "-s", endless_size});
}

TEST(ProgressBar, IsShownOnATerminalWhenTheWorkIsLong) {
    const TemporaryFolder folder;
    Command command = endless_render(folder);
    command.errors_to_terminal = true;
    Running program(command);
    EXPECT_TRUE(program.wait_for_errors("s left  endless"));
    program.send(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_TRUE(outcome.errors.starts_with("\r\x1b[K[")) << testing::PrintToString(outcome.errors);
    EXPECT_TRUE(contains(outcome.errors, " Mpixel/s, "));
    EXPECT_EQ(outcome.output, "");
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

TEST(ProgressBar, IsNotShownWhereStandardErrorIsNoTerminal) {
    const TemporaryFolder folder;
    Command command = endless_render(folder);
    Running silent(command);
    // The same work, begun later, at a terminal: when its bar was drawn many times, it was time for the other's too.
    command.errors_to_terminal = true;
    Running shown(command);
    ASSERT_TRUE(shown.wait_for_errors("s left", 6));
    silent.send(SIGTERM);
    const Outcome outcome = silent.wait();
    EXPECT_EQ(outcome.status, 143) << outcome;
    EXPECT_EQ(outcome.output + outcome.errors, "");
}

}  // namespace
}  // namespace sphereview::test

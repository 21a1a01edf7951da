// Standard input and output, and FIFOs.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "cli/fails.hpp"
#include "support/folders.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

TEST(Streams, ASceneFromStandardInputIsNamedStdin) {
    const TemporaryFolder folder;
    Command command = cpu_render(folder, {"-", "-s", "5x5", "--verbose"});
    command.input = red_scene;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"stdin.png"});
    EXPECT_FALSE(contains(outcome.errors, "-: "));
}

TEST(Streams, APictureOnStandardOutputIsTheOneInAFile) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    const Outcome streamed = render(folder, {"red.txt", "-s", "300x200", "-o", "-"});
    EXPECT_EQ(streamed.status, 0) << streamed;
    EXPECT_EQ(streamed.errors, "");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"red.txt"});
    ASSERT_EQ(render(folder, {"red.txt", "-s", "300x200"}).status, 0);
    EXPECT_TRUE(streamed.output == folder.read("red.png"));
}

TEST(Streams, AClosedOrFullStandardOutputIsAnOutputError) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    const std::vector<std::vector<std::string>> commands = {{"render", "--backend", "cpu", "red.txt", "-s", "300x300", "-o", "-"},
                                                            {"render", "--backend", "cpu", "red.txt", "-s", "3x3", "--json"},
                                                            {"convert", "red.txt", "-", "--to", "toml"},
                                                            {"--help"},
                                                            {"--version"}};
    for (const auto& arguments : commands) {
        for (const StandardOutput output : {StandardOutput::closed_pipe, StandardOutput::full_disk}) {
            const Outcome outcome = run({.arguments = arguments, .folder = folder.path(), .output = output});
            EXPECT_EQ(outcome.status, 4) << testing::PrintToString(arguments) << outcome;
            const bool full = output == StandardOutput::full_disk;
            EXPECT_EQ(outcome.errors,
                      std::string("stdout: cannot be written: ") + (full ? "No space left on device\n" : "Broken pipe\n"));
        }
    }
}

TEST(Streams, AMissingStandardOutputOrInputIsAnError) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    Command command = cpu_render(folder, {});
    command.program = "/bin/sh";
    command.arguments = {"-c", "exec \"$0\" render --backend cpu red.txt -s 3x3 -o - >&-", build_file("sphereview")};
    EXPECT_EQ(run(command).status, 4);
    command.arguments = {"-c", "exec \"$0\" render --backend cpu - -s 3x3 <&-", build_file("sphereview")};
    EXPECT_TRUE(fails(run(command), 2, "stdin: cannot be read: "));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"red.txt"});
}

TEST(Streams, FifosAreReadAndWrittenInPlace) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo(folder.path("scene").c_str(), 0600), 0);
    ASSERT_EQ(mkfifo(folder.path("picture").c_str(), 0600), 0);
    Running program(cpu_render(folder, {"scene", "-s", "5x5", "-o", "picture"}));
    std::ofstream(folder.path("scene")) << red_scene;
    const std::string png = folder.read("picture");
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(decode_png(png).at(2, 2), (std::vector<int>{255, 0, 0}));
    EXPECT_TRUE(std::filesystem::is_fifo(folder.path("picture")));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"picture", "scene"}));
}

}  // namespace
}  // namespace sphereview::test

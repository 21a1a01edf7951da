// Several scenes in one run.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

using Names = std::vector<std::string>;

TEST(Batch, WritesEachScenesPictureIntoTheCurrentFolderByDefault) {
    const TemporaryFolder folder;
    folder.write("sub/red.txt", red_scene);
    folder.write("sub/blue.version2.toml", blue_scene);
    const Outcome outcome = render(folder, {"sub/red.txt", "sub/blue.version2.toml", "-s", "5x5"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_EQ(folder.names(), (Names{"blue.version2.png", "red.png", "sub"}));
    EXPECT_EQ(decode_png(folder.read("red.png")).at(2, 2), (std::vector<int>{255, 0, 0}));
    EXPECT_EQ(decode_png(folder.read("blue.version2.png")).at(2, 2), (std::vector<int>{0, 0, 250}));
}

TEST(Batch, FillsTheNameIntoAPattern) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("out-red/other", "");
    folder.write("out-stdin/other", "");
    Command command = cpu_render(folder, {"red.txt", "-", "-s", "5x5", "-o", "out-{name}/{name}-small.png"});
    command.input = red_scene;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(folder.has("out-red/red-small.png"));
    EXPECT_TRUE(folder.has("out-stdin/stdin-small.png"));
}

TEST(Batch, GoesOnAfterABadSceneAndSummarises) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("bad.txt", bad_scene);
    folder.write("blue.txt", blue_scene);
    const Outcome outcome = render(folder, {"bad.txt", "red.txt", "missing.txt", "blue.txt", "-s", "5x5"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    const std::vector<std::string> said = lines(outcome.errors);
    ASSERT_EQ(said.size(), 3U) << outcome;
    EXPECT_TRUE(said[0].starts_with("bad.txt:4:1: ")) << said[0];
    EXPECT_TRUE(said[1].starts_with("missing.txt: cannot be read")) << said[1];
    EXPECT_EQ(said[2], "sphereview: 2 of 4 scenes failed: bad.txt missing.txt");
    EXPECT_EQ(folder.names(), (Names{"bad.txt", "blue.png", "blue.txt", "red.png", "red.txt"}));
}

TEST(Batch, GoesOnAfterAnOutputThatCannotBeWritten) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("blue.txt", blue_scene);
    folder.write("red.png/in-the-way", "");
    const Outcome outcome = render(folder, {"red.txt", "blue.txt", "-s", "5x5"});
    EXPECT_EQ(outcome.status, 4) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "red.png: cannot be written: it is a folder"));
    EXPECT_TRUE(contains(outcome.errors, "1 of 2 scenes failed: red.txt"));
    EXPECT_TRUE(folder.has("blue.png"));
}

TEST(Batch, OfOneSceneNeedsNoSummary) {
    const TemporaryFolder folder;
    folder.write("bad.txt", bad_scene);
    const Outcome outcome = render(folder, {"bad.txt"});
    EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
}

}  // namespace
}  // namespace sphereview::test

// Scenes that are packed with gzip.
#include "support/gzip.hpp"

#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

TEST(Gzip, APackedSceneIsRenderedUnderItsOwnName) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("packed.txt.gz", gzipped(red_scene));
    folder.write("Other.TOML.GZ", gzipped("[[sphere]]\ncolor = [255, 0, 0]\ncenter = [0, 0, 200]\nradius = 20\n"));
    folder.write("no-ending.gz", gzipped(red_scene));
    const Outcome outcome = render(folder, {"red.txt", "packed.txt.gz", "Other.TOML.GZ", "no-ending.gz", "-s", "5x5"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
    for (const std::string name : {"packed.png", "Other.png", "no-ending.png"}) {
        ASSERT_TRUE(folder.has(name)) << name;
        EXPECT_TRUE(folder.read(name) == folder.read("red.png")) << name;
    }
}

TEST(Gzip, StandardInputMayBePacked) {
    const TemporaryFolder folder;
    Command command = cpu_render(folder, {"-", "-s", "5x5"});
    command.input = gzipped(red_scene);
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(decode_png(folder.read("stdin.png")).at(2, 2), (std::vector<int>{255, 0, 0}));
}

TEST(Gzip, ManySpheresAreTheSamePacked) {
    const TemporaryFolder folder;
    const std::string scene = many_spheres(300'000);  // several times what is read at once
    folder.write("a.txt", scene);
    folder.write("b.txt.gz", gzipped(scene));
    const Outcome outcome = render(folder, {"a.txt", "b.txt.gz", "-s", "20x20"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
}

TEST(Gzip, AFaultIsPlacedInTheText) {
    const TemporaryFolder folder;
    folder.write("bad.txt.gz", gzipped(bad_scene));
    const Outcome outcome = render(folder, {"bad.txt.gz"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(outcome.errors.starts_with("bad.txt.gz:4:1: found '-5', expected ")) << outcome;
}

TEST(Gzip, DamageIsAnErrorInOneLine) {
    const TemporaryFolder folder;
    const std::string packed = gzipped(red_scene);
    folder.write("short.txt.gz", packed.substr(0, packed.size() - 4));
    const Outcome outcome = render(folder, {"short.txt.gz"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.errors, "short.txt.gz: cannot be unpacked: its gzip data end too early\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"short.txt.gz"});
}

TEST(Gzip, ABombIsRefusedInLittleMemory) {
    const TemporaryFolder folder;
    // 1000 members of 1 MB of spaces: 1 GB in 1 MB. As a text it needs memory only until it is refused.
    const std::string spaces = gzipped(std::string(1'000'000, ' '));
    std::string bomb = gzipped("1\n");
    for (int i = 0; i < 1000; ++i) bomb += spaces;
    folder.write("bomb.txt.gz", bomb);
    const Outcome outcome = render(folder, {"bomb.txt.gz"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.errors, "bomb.txt.gz: cannot be unpacked: its text is longer than 250 times the file, as no scene's is\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bomb.txt.gz"});
}

TEST(Gzip, IsOnlyRead) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    Command command;
    command.folder = folder.path();
    for (const std::string name : {"b.toml.gz", "b.txt.GZ"}) {
        command.arguments = {"convert", "red.txt", name};
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.errors,
                  name + ": found a name for gzip, which is only read; expected one that ends with .txt or .toml\n");
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"red.txt"});
}

}  // namespace
}  // namespace sphereview::test

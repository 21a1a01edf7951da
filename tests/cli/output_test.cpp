// What is written and with which exit status: one picture, several, none.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "cli/in_folder.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"
#include "support/trials.hpp"

namespace sphereview::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class Output : public InFolder {
protected:
    Output() { folder_.write("red.txt", red_scene); }

    Outcome render_into(const std::string& path) const { return render(folder_, {"red.txt", "-s", "5x5", "-o", path}); }
};

// tests/unit/output_file_test.cpp has every reason.
TEST_F(Output, ThatCannotBeIsRefusedWithTheReason) {
    folder_.write("folder/file", "");
    const auto before = folder_.names();
    for (const auto& [path, said] : {std::pair{"folder/", "it is a folder"},
                                     {"missing/new.png", "the folder missing does not exist"},
                                     {"/proc/new.png", ""},
                                     {"/dev/full", "No space left on device"}}) {
        EXPECT_TRUE(fails(render_into(path), 4, std::string(path) + ": cannot be written: " + said));
        EXPECT_EQ(folder_.names(), before) << path;
    }
}

TEST_F(Output, IsNamedAsWhatItIs) {
    const auto before = folder_.names();
    for (const std::string ending : {".jpg", ".JPEG", ".tif", ".bmp", ".txt", ".mp4"}) {
        const std::string said = ": found the ending " + ending + ", expected .png: pictures are written as PNG alone\n";
        EXPECT_TRUE(fails(render_into("x" + ending), 2, "x" + ending + said));
        EXPECT_TRUE(fails(render_into("{name}" + ending), 2, "{name}" + ending + said));
        EXPECT_TRUE(fails(render(folder_, {"red.txt", "--expect", "none.png", "--diff", "d" + ending}), 2, "d" + ending + said));
        EXPECT_TRUE(fails(sphereview({"compare", "red.png", "red.txt", "--diff", "d" + ending}), 2, "d" + ending + said));
    }
    EXPECT_TRUE(fails(render_into("x."), 2, "x.: found no ending behind the last '.', expected .png or a name without one\n"));
    EXPECT_EQ(folder_.names(), before);

    folder_.write("blue.v2.toml", blue_scene);
    EXPECT_EQ(render(folder_, {"red.txt", "blue.v2.toml", "-s", "5x5", "-o", "{name}"}).status, 0);
    for (const char* path : {"plain", "frame.0001", "upper.PNG"}) EXPECT_EQ(render_into(path).status, 0) << path;
    EXPECT_EQ(folder_.names(),
              (Names{"blue.v2.png", "blue.v2.toml", "frame.0001.png", "plain.png", "red.png", "red.txt", "upper.PNG"}));
    // Where there is no name to give.
    EXPECT_EQ(render_into("/dev/null").status, 0);
    EXPECT_EQ(folder_.names().size(), 7U);
}

TEST_F(Output, ThatIsRefusedIsRefusedBeforeTheScenesAreRead) {
    EXPECT_TRUE(fails(render(folder_, {"missing.txt", "-o", "folder/new.png"}), 4, "folder/new.png: cannot be written"));
}

TEST_F(Output, DoesNotReplaceWhatIsProtected) {
    folder_.write("protected.png", "old");
    fs::permissions(folder_.path("protected.png"), fs::perms::owner_read);
    folder_.write("locked/old.png", "old");
    fs::permissions(folder_.path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
    for (const char* path : {"protected.png", "locked/new.png"}) {
        Command command = cpu_render(folder_, {"red.txt", "-s", "5x5", "-o", path});
        command.obeys_permissions = true;
        EXPECT_TRUE(fails(run(command), 4, std::string(path) + ": cannot be written: Permission denied\n"));
    }
    EXPECT_EQ(folder_.read("protected.png"), "old");
    fs::permissions(folder_.path("locked"), fs::perms::owner_all);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path("locked")), fs::directory_iterator()), 1);
}

TEST_F(Output, BeyondAFileSizeLimitLeavesTheOldFileAndNothingElse) {
    folder_.write("old.png", "old");
    folder_.write("old.toml", "old");
    for (const char* path : {"old.png", "new.png"}) {
        Command command = cpu_render(folder_, {"red.txt", "-s", "1000x1000", "-o", path});
        command.largest_file = 100;
        EXPECT_TRUE(fails(run(command), 4, std::string(path) + ": cannot be written: File too large\n"));
    }
    EXPECT_EQ(run({.arguments = {"convert", "red.txt", "old.toml"}, .folder = folder_.path(), .largest_file = 10}).status, 4);
    EXPECT_EQ(folder_.read("old.png"), "old");
    EXPECT_EQ(folder_.read("old.toml"), "old");
    EXPECT_EQ(folder_.names(), (Names{"old.png", "old.toml", "red.txt"}));
}

// A compressor whose choices depended on where its memory lies packed this picture in one of three ways: one of 40 processes
// differed.
TEST(Png, IsTheSameBytesInEveryProcess) {
    const TemporaryFolder folder;
    folder.write("empty.txt", "0");
    for (int process = 0; process < trials(100); ++process) {
        const std::string path = process == 0 ? "first.png" : "next.png";
        const Outcome outcome = render(folder, {"empty.txt", "-s", "8x2", "--background", "white", "--no-sync", "-o", path});
        ASSERT_EQ(outcome.status, 0) << outcome;
        ASSERT_EQ(folder.read(path), folder.read("first.png")) << "process " << process;
    }
}

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

TEST(Batch, FillsTheNameIntoAPatternAndMakesItsFolder) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
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

TEST(ExitStatus, SaysWhatWentWrongAndOfSeveralTheHighestCounts) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    folder.write("blue.txt", blue_scene);
    folder.write("bad.txt", bad_scene);
    ASSERT_EQ(render(folder, {"red.txt", "-s", "5x5", "-o", "golden.png"}).status, 0);
    const std::vector<std::pair<std::vector<std::string>, int>> cases = {
        {{"red.txt", "red.txt", "--expect", "golden.png"}, 0},
        {{"red.txt", "blue.txt", "--expect", "golden.png"}, 1},
        {{"blue.txt", "bad.txt", "red.txt", "--expect", "golden.png"}, 2},
        {{"bad.txt", "red.txt", "-o", "/dev/full/{name}.png"}, 4},
        {{"blue.txt", "--expect", "golden.png", "-o", "/dev/full"}, 4},
    };
    for (const auto& [arguments, status] : cases) {
        const Outcome outcome = render(folder, all_words({"-s", "5x5"}, arguments));
        EXPECT_EQ(outcome.status, status) << testing::PrintToString(arguments) << ": " << outcome;
        EXPECT_EQ(outcome.errors.empty(), status == 0) << outcome;
    }
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
TEST(ExitStatus, Is3WhenMemoryRunsOut) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    Command command = cpu_render(folder, {"red.txt", "-s", "20000x20000"});  // 1.2 GB of pixels
    command.most_memory = 1'000'000'000;
    EXPECT_TRUE(fails(run(command), 3, "red.txt: memory ran out\n"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"red.txt"});
}

TEST(ExitStatus, Is3WhenASceneCannotFitInMemory) {
    const TemporaryFolder folder;
    const std::string blanks(1 << 16, ' ');  // where a file shows what it is, it is text
    folder.write("big.txt", "50000000\n" + blanks);
    folder.write("big.toml", "# \n" + blanks);
    for (const char* name : {"big.txt", "big.toml"}) std::filesystem::resize_file(folder.path(name), 1'500'000'000);  // sparse
    for (const auto& [name, said] : {std::pair{"big.txt", "big.txt: 50,000,000 spheres need 6.5 GB of memory, "},
                                     std::pair{"big.toml", "big.toml: its bytes need 1.5 GB of memory, "}}) {
        Command command = cpu_render(folder, {name, "-s", "5x5"});
        command.most_memory = 1'000'000'000;
        const Outcome outcome = run(command);
        EXPECT_TRUE(fails(outcome, 3, said));
        EXPECT_TRUE(outcome.errors.ends_with(" MB are available\n")) << outcome;
    }
}
#endif

}  // namespace
}  // namespace sphereview::test

// Comparing with a golden picture, and command lines that would destroy one or another file.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

class Expect : public testing::Test {
protected:
    Expect() {
        folder_.write("red.txt", red_scene);
        folder_.write("blue.txt", blue_scene);
        Picture golden = plain_picture(5, 5, {0, 0, 0});
        golden.bytes[36] = '\xFF';  // the middle pixel is red
        folder_.write("golden.png", encode_png(golden));
        before_ = folder_.names();
    }

    Outcome render_small(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"-s", "5x5"});
        return render(folder_, arguments);
    }

    TemporaryFolder folder_;
    std::vector<std::string> before_;
};

TEST_F(Expect, EqualIsSilentAndWritesNothing) {
    const Outcome outcome = render_small({"red.txt", "--expect", "golden.png"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output + outcome.errors, "");
    EXPECT_EQ(folder_.names(), before_);
}

TEST_F(Expect, DifferentSaysHowManyPixelsHowFarAndWhereTheFirstIs) {
    const Outcome outcome = render_small({"blue.txt", "--expect", "golden.png"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_EQ(outcome.errors,
              "blue.txt: differs from golden.png: 1 of 25 pixels differ, by at most R 255 G 0 B 250; "
              "the first at pixel 2,2: found (0, 0, 250), expected (255, 0, 0)\n");
    EXPECT_EQ(folder_.names(), before_);
}

TEST_F(Expect, AnotherSizeIsToldByTheHeader) {
    std::string header = folder_.read("golden.png");
    header.resize(header.find("IDAT") + 4);
    header.replace(8 + 8, 8, std::string("\0\0\xEA\x60\0\0\xEA\x60", 8));
    header.replace(8 + 21, 4, "\x0F\xB0\xE2\x15");  // the sum of that
    folder_.write("claims.png", header);
    EXPECT_TRUE(fails(render_small({"red.txt", "--expect", "claims.png"}), 1,
                      "red.txt: differs from claims.png: the picture is 5x5, expected 60000x60000\n"));
    EXPECT_TRUE(fails(render_small({"red.txt", "--expect", "claims.png", "--diff", "diff.png"}), 2,
                      "claims.png: the picture of the difference, of 60000x60000 pixels, is too large"));
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
TEST_F(Expect, NeedsMemoryForThePictureAloneAndSaysWhenThatRunsOut) {
    const auto command = [&](const std::string& size, rlim_t memory) {
        Command compare = cpu_render(folder_, {"red.txt", "--expect", "large.png", "-s", size});
        compare.most_memory = memory;
        return compare;
    };
    ASSERT_EQ(render(folder_, {"red.txt", "-o", "large.png", "-s", "8000x8000"}).status, 0);
    // 192 MB of pixels, and what threads reserve.
    EXPECT_EQ(run(command("8000x8000", 192'000'000 + 250'000'000)).status, 0);
    // libpng holds rows, which here are the picture.
    ASSERT_EQ(render(folder_, {"red.txt", "-o", "large.png", "-s", "64000000x1"}).status, 0);
    const Outcome outcome = run(command("64000000x1", 192'000'000 + 250'000'000));
    EXPECT_EQ(outcome.status, 3) << outcome;
    EXPECT_TRUE(outcome.errors.ends_with("red.txt: memory ran out\n")) << outcome;
}
#endif

TEST_F(Expect, AMissingOrBrokenGoldenIsABadInput) {
    const std::string png = folder_.read("golden.png");
    folder_.write("cut.png", png.substr(0, png.size() / 2));
    folder_.write("folder/file", "");
    const auto before = folder_.names();
    for (const char* golden : {"missing.png", "cut.png", "blue.txt", "folder"}) {
        EXPECT_TRUE(fails(render_small({"red.txt", "--expect", golden}), 2, std::string(golden) + ": "));
    }
    EXPECT_EQ(folder_.names(), before);
}

TEST_F(Expect, WithAnOutputWritesThePictureToo) {
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "-o", "actual.png"}).status, 1);
    EXPECT_EQ(decode_png(folder_.read("actual.png")).at(2, 2), (std::vector<int>{0, 0, 250}));
}

TEST_F(Expect, DiffMarksTheDifferentPixels) {
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "--diff", "diff.png"}).status, 1);
    Picture marked = plain_picture(5, 5, {0, 0, 0});
    marked.bytes.replace(36, 3, "\xFF\xFF\xFF");
    EXPECT_EQ(decode_png(folder_.read("diff.png")), marked);
}

TEST_F(Expect, ADiffThatCannotBeWrittenCountsMoreThanTheDifference) {
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "--diff", "missing/diff.png"}).status, 4);
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "--diff", "/dev/full"}).status, 4);
}

TEST_F(Expect, FillsTheNameInForEachScene) {
    ASSERT_EQ(render_small({"red.txt", "blue.txt", "-o", "want-{name}.png"}).status, 0);
    EXPECT_EQ(render_small({"red.txt", "blue.txt", "--expect", "want-{name}.png"}).status, 0);
    folder_.write("blue.txt", "0");
    const Outcome outcome = render_small({"red.txt", "blue.txt", "--expect", "want-{name}.png", "--diff", "new/diff-{name}.png"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "blue.txt: differs from want-blue.png: 1 of 25"));
    EXPECT_TRUE(contains(outcome.errors, "1 of 2 scenes failed: blue.txt"));
    EXPECT_TRUE(folder_.has("new/diff-red.png") && folder_.has("new/diff-blue.png"));
}

TEST_F(Expect, TakesAGoldenThroughAPipe) {
    for (const char* path : {"-", "/dev/stdin"}) {
        Command command = cpu_render(folder_, {"red.txt", "--expect", path, "-s", "5x5"});
        command.input = folder_.read("golden.png");
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
    }
}

class Refusal : public testing::Test {
protected:
    Refusal() {
        folder_.write("a.txt", red_scene);
        folder_.write("b.txt", blue_scene);
        folder_.write("other/a.txt", red_scene);
        folder_.write("scene.png", red_scene);  // a scene whose name a picture may have
        folder_.write("golden.png", encode_png(plain_picture(5, 5, {0, 0, 0})));
        std::filesystem::create_symlink("a.txt", folder_.path("link-to-a.png"));
        std::filesystem::create_symlink("golden.png", folder_.path("link-to-golden.png"));
        std::filesystem::create_symlink("new.png", folder_.path("dangling.png"));
        std::filesystem::create_directory_symlink(".", folder_.path("here"));
    }

    void expect_refused(const Command& command, const std::string& said) const {
        SCOPED_TRACE(testing::PrintToString(command.arguments));
        const auto before = folder_.names();
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
        EXPECT_EQ(folder_.names(), before);
        EXPECT_EQ(folder_.read("a.txt"), red_scene);
    }

    TemporaryFolder folder_;
};

TEST_F(Refusal, OfAnOutputThatIsAnInputAGoldenOrAnotherOutput) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"scene.png", "-o", "scene.png"}, "scene.png: cannot be both the picture of scene.png and the scene scene.png"},
        {{"a.txt", "-o", "link-to-a.png"}, "link-to-a.png: cannot be both"},
        {{"here/scene.png", "-o", "scene.png"}, "cannot be both"},
        {{"b.txt", "scene.png", "-o", "{name}.png"}, "cannot be both"},
        {{"b.txt", "scene.png", "-o", "scene"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "golden.png"},
         "golden.png: cannot be both the picture of a.txt and the expected picture"},
        {{"a.txt", "--expect", "link-to-golden.png", "-o", "here/golden.png"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "--diff", "golden.png"},
         "cannot be both the difference picture of a.txt and the expected"},
        {{"a.txt", "--expect", "golden.png", "--diff", "link-to-a.png"}, "cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "new.png", "--diff", "new.png"}, "new.png: cannot be both"},
        {{"a.txt", "--expect", "golden.png", "-o", "new.png", "--diff", "here/dangling.png"}, "cannot be both"},
        {{"a.txt", "b.txt", "-o", "new.png"}, "new.png: cannot be both the picture of b.txt and the picture of a.txt; use {name}"},
        {{"a.txt", "other/a.txt"}, "a.png: cannot be both"},
        {{"a.txt", "other/a.txt", "-o", "{name}.png"}, "; both scenes are called 'a': render them one at a time"},
        {{"a.txt", "a.txt"}, "; both scenes are called 'a': render them one at a time"},
        {{"a.txt", "--expect", "golden.png", "-o", "{name}.png", "--diff", "{name}.png"}, "; they need two names"},
        {{"a.txt", "ba.txt", "--expect", "golden.png", "-o", "b{name}.png", "--diff", "{name}.png"}, "; choose another pattern"},
        {{"a.txt", "b.txt", "--expect", "golden.png", "--diff", "d.png"}, "d.png: cannot be both"},
        {{"a.txt", "b.txt", "-o", "-"}, "stdout cannot be both"},
        {{"a.txt", "-o", "-", "--json"}, "stdout cannot be both the JSON report and the picture of a.txt"},
        {{"a.txt", "--expect", "golden.png", "-o", "-", "--diff", "-"}, "stdout cannot be both"},
        {{"-", "-"}, "stdin cannot be both"},
        {{"-", "--expect", "-"}, "stdin cannot be both"},
    };
    for (const auto& [arguments, said] : cases) expect_refused(cpu_render(folder_, arguments), said);
}

TEST_F(Refusal, OfConvertingAFileIntoItself) {
    std::filesystem::create_symlink("a.txt", folder_.path("link.toml"));
    for (const char* output : {"a.txt", "link.toml"}) {
        expect_refused({.arguments = {"convert", "a.txt", output, "--to", "toml"}, .folder = folder_.path()},
                       std::string(output) + ": the output is also the input");
    }
}

TEST_F(Refusal, DoesNotConcernDevicesAndRepeatedReading) {
    const std::vector<std::vector<std::string>> cases = {
        {"a.txt", "b.txt", "-o", "/dev/null"},
        {"a.txt", "a.txt", "-o", "/dev/null"},
        {"/dev/stdin", "-o", "/dev/null"},
    };
    for (const auto& arguments : cases) {
        Command command = cpu_render(folder_, arguments);
        command.arguments.insert(command.arguments.end(), {"-s", "5x5"});
        command.input = red_scene;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
    }
    // One golden for two scenes is read twice.
    EXPECT_EQ(render(folder_, {"a.txt", "other/a.txt", "-s", "5x5", "--expect", "golden.png"}).status, 1);
}

}  // namespace
}  // namespace sphereview::test

// Comparing a picture with a golden one.
#include <gtest/gtest.h>

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

TEST_F(Expect, AnotherSizeIsADifference) {
    const Outcome outcome = render(folder_, {"red.txt", "--expect", "golden.png", "-s", "5x4"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_EQ(outcome.errors, "red.txt: differs from golden.png: the picture is 5x4, expected 5x5\n");
}

TEST_F(Expect, TransparencyCounts) {
    const Outcome outcome = render_small({"red.txt", "--expect", "golden.png", "--background", "transparent"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_TRUE(contains(outcome.errors,
                         "24 of 25 pixels differ, by at most R 0 G 0 B 0 A 255; the first at pixel 0,0: "
                         "found (0, 0, 0, 0), expected (0, 0, 0, 255)"));
    Picture opaque = plain_picture(5, 5, {0, 0, 0, 255});
    opaque.bytes[48] = '\xFF';
    folder_.write("opaque.png", encode_png(opaque));
    EXPECT_EQ(render_small({"red.txt", "--expect", "opaque.png"}).status, 0);
}

TEST_F(Expect, AMissingOrBrokenGoldenIsABadInput) {
    const std::string png = folder_.read("golden.png");
    std::string corrupt = png;
    corrupt[corrupt.size() - 20] ^= '\x55';
    folder_.write("cut.png", png.substr(0, png.size() / 2));
    folder_.write("header.png", png.substr(0, 20));
    folder_.write("corrupt.png", corrupt);
    folder_.write("endless.png", png.substr(0, png.size() - 12));  // all pixels, but no last chunk
    folder_.write("empty.png", "");
    folder_.write("folder/file", "");
    const auto before = folder_.names();
    for (const char* golden :
         {"endless.png", "missing.png", "cut.png", "header.png", "corrupt.png", "empty.png", "blue.txt", "folder"}) {
        const Outcome outcome = render_small({"red.txt", "--expect", golden});
        EXPECT_EQ(outcome.status, 2) << golden << ": " << outcome;
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with(std::string(golden) + ": ")) << outcome;
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

    EXPECT_EQ(render(folder_, {"red.txt", "--expect", "golden.png", "--diff", "diff.png", "-s", "7x3"}).status, 1);
    const Picture both = decode_png(folder_.read("diff.png"));
    EXPECT_EQ(both.width, 7);
    EXPECT_EQ(both.height, 5);
    EXPECT_EQ(both.at(6, 4), (std::vector<int>{255, 0, 255}));
}

TEST_F(Expect, ADiffThatCannotBeWrittenCountsMoreThanTheDifference) {
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "--diff", "missing/diff.png"}).status, 4);
    EXPECT_EQ(render_small({"blue.txt", "--expect", "golden.png", "--diff", "/dev/full"}).status, 4);
}

TEST_F(Expect, FillsTheNameInForEachScene) {
    ASSERT_EQ(render_small({"red.txt", "blue.txt", "-o", "want-{name}.png"}).status, 0);
    EXPECT_EQ(render_small({"red.txt", "blue.txt", "--expect", "want-{name}.png"}).status, 0);
    folder_.write("blue.txt", "0");
    const Outcome outcome = render_small({"red.txt", "blue.txt", "--expect", "want-{name}.png", "--diff", "diff-{name}.png"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "blue.txt: differs from want-blue.png: 1 of 25"));
    EXPECT_TRUE(contains(outcome.errors, "1 of 2 scenes failed: blue.txt"));
    EXPECT_TRUE(folder_.has("diff-red.png") && folder_.has("diff-blue.png"));
}

TEST_F(Expect, TakesAGoldenThroughAPipe) {
    for (const char* path : {"-", "/dev/stdin"}) {
        Command command = cpu_render(folder_, {"red.txt", "--expect", path, "-s", "5x5"});
        command.input = folder_.read("golden.png");
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
    }
}

}  // namespace
}  // namespace sphereview::test

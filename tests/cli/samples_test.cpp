// --samples: each pixel the average of exact points.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

const std::string scene = "3  255 0 0  0 0 200 41  0 0 250  40 3 150 30  0 255 7  -20 -25 120 12";

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

// What --samples must make of the scene: the picture of `side` times the size, averaged.
Picture expected(const std::string& background, int width, int height, int side) {
    return averaged(picture_of(scene, "cpu", {"-s", size_text(width * side, height * side), "--background", background}), side);
}

TEST(Samples, OfOneIsThePictureWithout) {
    EXPECT_EQ(picture_of(scene, "cpu", {"-s", "50x40", "--samples", "1"}), picture_of(scene, "cpu", {"-s", "50x40"}));
}

TEST(Samples, AreTheAverageOfALargerPicture) {
    for (const auto& [samples, side] : {std::pair{"4", 2}, {"16", 4}}) {
        for (const char* background : {"black", "#102030", "transparent"}) {
            SCOPED_TRACE(std::string(samples) + " " + background);
            for (const auto& [width, height] : {std::pair{50, 41}, {1, 1}, {301, 1}, {1, 97}, {333, 200}}) {
                const Picture picture =
                    picture_of(scene, "cpu", {"-s", size_text(width, height), "--background", background, "--samples", samples});
                EXPECT_EQ(picture, expected(background, width, height, side)) << width << " x " << height;
            }
        }
    }
}

// Such a picture is traced in several columns of blocks.
TEST(Samples, OfAPictureWiderThanABlock) {
    EXPECT_EQ(picture_of(scene, "cpu", {"-s", "200001x2", "--samples", "4"}), expected("black", 200'001, 2, 2));
}

TEST(Samples, KeepInsidesAndSmoothEdges) {
    const Picture picture = picture_of(scene, "cpu", {"-s", "101x101", "--background", "transparent", "--samples", "4"});
    EXPECT_EQ(picture.at(50, 50), (std::vector<int>{255, 0, 0, 255}));
    EXPECT_EQ(picture.at(0, 0), (std::vector<int>{0, 0, 0, 0}));
    int partly = 0;
    for (int i = 0; i < 101 * 101; ++i) {
        const int alpha = picture.at(i % 101, i / 101)[3];
        EXPECT_TRUE(alpha == 0 || alpha == 64 || alpha == 128 || alpha == 191 || alpha == 255) << alpha;
        if (alpha != 0 && alpha != 255) ++partly;
    }
    EXPECT_GT(partly, 50);
}

TEST(Samples, AreExpectedLikeAnyPicture) {
    const TemporaryFolder folder;
    folder.write("scene.txt", scene);
    ASSERT_EQ(render(folder, {"scene.txt", "-s", "60x60", "--samples", "4", "-o", "golden.png"}).status, 0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "60x60", "--samples", "4", "--expect", "golden.png"}).status, 0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "60x60", "--samples", "16", "--expect", "golden.png"}).status, 1);
}

TEST(Samples, AreReported) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    const Outcome outcome = render(folder, {"red.txt", "-s", "5x4", "--samples", "16", "--json", "--verbose"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    const auto report = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(report["samples"], 16);
    EXPECT_EQ(report["size"], nlohmann::json({5, 4}));
    EXPECT_EQ(report["decided"]["float"], 5 * 4 * 16);
    EXPECT_TRUE(contains(outcome.errors, "red.txt: points (16 a pixel) decided: 320 in float, 0 in double, 0 exactly"));
    EXPECT_TRUE(contains(outcome.errors, "tiles of 8 points, "));
    EXPECT_EQ(nlohmann::json::parse(render(folder, {"red.txt", "-s", "5x4", "--json"}).output)["samples"], 1);
}

TEST(Samples, ThatCannotBeAreRefused) {
    const TemporaryFolder folder;
    for (const char* count : {"0", "2", "3", "-4", "4.0", "64", "many", "", "4 ", "99999999999999999999"}) {
        const Outcome outcome = render(folder, {"missing.txt", std::string("--samples=") + count + "", "-s", "5x5"});
        if (std::string(count).empty()) {
            EXPECT_TRUE(contains(outcome.errors, "--samples: found no value, expected N"));
        } else {
            EXPECT_TRUE(contains(outcome.errors, "--samples: found '" + std::string(count) + "', expected 1, 4 or 16 (see"));
        }
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
    }
}

TEST(Samples, OfPicturesThatAreTooWideAreRefusedBeforeAnyWork) {
    const TemporaryFolder folder;
    const std::vector<std::tuple<std::string, std::string, std::string>> cases = {
        {"107374183x1", "16", "107374182"}, {"1x107374183", "16", "107374182"}, {"214748365x1", "4", "214748364"}};
    for (const auto& [size, samples, longest] : cases) {
        const Outcome outcome = render(folder, {"missing.txt", "-s", size, "--samples", samples});
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "--size: found '" + size + "', expected sides of at most " + longest +
                                                 " pixels with --samples " + samples));
    }
    // One less is only a missing file.
    const Outcome outcome = render(folder, {"missing.txt", "-s", "107374182x1", "--samples", "16"});
    EXPECT_TRUE(contains(outcome.errors, "missing.txt: cannot be read"));
}

}  // namespace
}  // namespace sphereview::test

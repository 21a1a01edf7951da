// What --shade does to a picture.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Seen in its middle: facing the eye, as near as anything.
constexpr const char* red_sphere = "1\n200 100 0\n0 0 200\n20\n";

TEST(Shade, GivesTheColoursOfEachMode) {
    const std::vector<std::pair<std::string, std::vector<int>>> cases = {{"flat", {200, 100, 0}},
                                                                         {"headlight", {200, 100, 0}},
                                                                         {"normal", {128, 128, 255}},
                                                                         {"depth", {255, 255, 255}},
                                                                         {"id", {255, 30, 30}}};
    for (const auto& [mode, color] : cases) {
        const Picture picture = picture_of(red_sphere, "cpu", {"-s", "5x5", "--shade", mode});
        EXPECT_EQ(picture.at(2, 2), color) << mode;
        EXPECT_EQ(picture.at(0, 0), (std::vector<int>{0, 0, 0})) << mode;
    }
}

TEST(Shade, DimsWhatIsFarAndWhatTurnsAway) {
    const std::string scene = "2\n200 200 200 0 0 200 60\n200 200 200 100 0 400 40\n";
    const Picture picture = picture_of(scene, "cpu", {"-s", "101x101", "--shade", "headlight"});
    EXPECT_GT(picture.at(50, 50)[0], picture.at(65, 50)[0] + 10);
    EXPECT_GT(picture.at(65, 50)[0], 20);
    EXPECT_LT(picture.at(75, 50)[0], 130);
    EXPECT_GT(picture.at(75, 50)[0], 90);
}

TEST(Shade, IsFlatUnlessAskedFor) {
    EXPECT_EQ(picture_of(red_scene, "cpu", {"-s", "50x50"}), picture_of(red_scene, "cpu", {"-s", "50x50", "--shade", "flat"}));
}

TEST(Shade, RefusesWhatIsNoMode) {
    const TemporaryFolder folder;
    folder.write("scene.txt", red_scene);
    for (const char* wrong : {"Flat", "lambert", ""}) {
        const Outcome outcome = render(folder, {"scene.txt", "--shade", wrong});
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.errors, std::string("sphereview: --shade: found '") + wrong +
                                      "', expected flat, headlight, normal, depth or id (see 'sphereview render --help')\n");
    }
}

TEST(Shade, IsComparedAndReported) {
    const TemporaryFolder folder;
    folder.write("scene.txt", red_scene);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--shade", "normal", "-o", "golden.png"}).status, 0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--shade", "normal", "--expect", "golden.png"}).status, 0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--expect", "golden.png"}).status, 1);
    const Outcome outcome = render(folder, {"scene.txt", "-s", "9x9", "--shade", "id", "--json", "--verbose"});
    EXPECT_EQ(nlohmann::json::parse(outcome.output).at("shade"), "id");
    EXPECT_NE(outcome.errors.find("; shaded: id"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace sphereview::test

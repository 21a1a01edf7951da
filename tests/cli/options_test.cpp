// What --size, --background and the backend's name do to a picture.
#include <gtest/gtest.h>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

const std::vector<int> red = {255, 0, 0};

TEST(Size, IsWhatThePictureHas) {
    struct Case {
        std::string option;
        int width;
        int height;
    };
    for (const auto& [option, width, height] :
         std::vector<Case>{{"1x1", 1, 1}, {"1000,1000", 1000, 1000}, {"7x3", 7, 3}, {"3X7", 3, 7}, {"2001x1", 2001, 1}}) {
        const Picture picture = picture_of(red_scene, "cpu", {"-s", option});
        EXPECT_EQ(picture.width, width) << option;
        EXPECT_EQ(picture.height, height) << option;
        EXPECT_EQ(picture.at(width / 2, height / 2), red) << option;
    }
    // A pixel of a row one pixel high is as wide as the screen: only the middle one meets the sphere.
    EXPECT_EQ(picture_of(red_scene, "cpu", {"-s", "2001x1"}).at(999, 0), (std::vector<int>{0, 0, 0}));
    const Picture standard = picture_of(red_scene, "cpu");
    EXPECT_EQ(standard.width, 1000);
    EXPECT_EQ(standard.height, 1000);
}

TEST(Size, ThatCannotBeIsRefusedBeforeAnyWork) {
    const TemporaryFolder folder;
    for (const std::string size :
         {"0x5", "5x0", "-5x5", "1000000x1000000", "429496730x1", "99999999999x1", "1x99999999999999999999", "10", "10x", "x10",
          "10x10x10", "10x10.5", "1e3x5", " 5x5", "big", ""}) {
        const Outcome outcome = render(folder, {"missing.txt", "--size", size});
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.errors, "sphereview: --size: found '" + size +
                                      "', expected WIDTHxHEIGHT, such as 1000x1000: sides of at "
                                      "least 1 pixel, at most 429496729 pixels (see 'sphereview render --help')\n");
    }
    EXPECT_EQ(render(folder, {"missing.txt", "--size", "429496729x1"}).errors.find("missing.txt"), 0U);
}

TEST(Background, IsAnyColourOrNone) {
    const std::vector<std::pair<std::string, std::vector<int>>> cases = {{"black", {0, 0, 0}},
                                                                         {"white", {255, 255, 255}},
                                                                         {"#ff8001", {255, 128, 1}},
                                                                         {"#FFaA00", {255, 170, 0}},
                                                                         {"transparent", {0, 0, 0, 0}}};
    for (const auto& [option, color] : cases) {
        const Picture picture = picture_of(red_scene, "cpu", {"-s", "5x5", "--background", option});
        Picture expected = plain_picture(5, 5, color);
        const std::string sphere("\xFF\x00\x00\xFF", color.size());
        expected.bytes.replace(color.size() * 12, color.size(), sphere);
        EXPECT_EQ(picture, expected) << option;
    }
}

TEST(Background, OfTheOptionCountsMoreThanTheScenes) {
    const std::string scene = "background = \"#010203\"\nspheres = \"0\"";
    EXPECT_EQ(picture_of(scene, "cpu", {"-s", "2x1"}), plain_picture(2, 1, {1, 2, 3}));
    EXPECT_EQ(picture_of(scene, "cpu", {"-s", "2x1", "--background", "white"}), plain_picture(2, 1, {255, 255, 255}));
    EXPECT_EQ(picture_of("background = 'transparent'", "cpu", {"-s", "1x2"}), plain_picture(1, 2, {0, 0, 0, 0}));
}

TEST(Background, ThatIsNoColourIsRefused) {
    for (const char* color : {"red", "#ff80", "#gggggg", "#ff80001", "BLACK", " white", "0xff8000", ""}) {
        const Outcome outcome = run({"render", "missing.txt", "--background", color});
        EXPECT_EQ(outcome.status, 2) << color << ": " << outcome;
        EXPECT_TRUE(contains(outcome.errors,
                             "--background: found '" + std::string(color) + "', expected black, white, transparent or #rrggbb"));
    }
}

struct BackendCase {
    std::optional<std::string> variable;
    std::vector<std::string> options;
    std::string said;
    int status;
};

TEST(BackendVariable, ChoosesUnlessTheOptionDoes) {
    const TemporaryFolder folder;
    folder.write("scene.txt", red_scene);
    const std::vector<BackendCase> cases = {
        {"cpu", {}, "scene.txt: backend: cpu\n", 0},
        {"vulkan", {"--backend", "cpu"}, "scene.txt: backend: cpu\n", 0},
        {"osmesa", {"--backend", "cpu"}, "scene.txt: backend: cpu\n", 0},
        {"vulkan", {}, "SPHEREVIEW_BACKEND: found 'vulkan', expected auto, egl, osmesa or cpu", 2},
        {"cpu", {"--backend", "vulkan"}, "--backend: found 'vulkan', expected auto, egl, osmesa or cpu", 2},
    };
    for (const auto& [variable, options, said, status] : cases) {
        Command command;
        command.arguments = {"render", "scene.txt", "-s", "5x5", "--verbose"};
        command.arguments.insert(command.arguments.end(), options.begin(), options.end());
        command.environment = {{"SPHEREVIEW_BACKEND", variable}};
        command.folder = folder.path();
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, status) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
    }
}

}  // namespace
}  // namespace sphereview::test

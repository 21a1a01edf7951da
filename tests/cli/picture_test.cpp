// What --size, --background, --backend, --samples, --shade, --fit and --view do to a picture.
#include <gtest/gtest.h>

#include "support/json.hpp"
#include "support/render.hpp"
#include "support/sha256.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

using Pixel = std::vector<int>;
const Pixel red = {255, 0, 0};
const Pixel green = {0, 255, 0};
const Pixel blue = {0, 0, 255};
const Pixel black = {0, 0, 0};

TEST(Size, IsWhatThePictureHas) {
    for (const auto& [option, width, height] : std::vector<std::tuple<std::string, int, int>>{
             {"1x1", 1, 1}, {"1000,1000", 1000, 1000}, {"7x3", 7, 3}, {"3X7", 3, 7}, {"2001x1", 2001, 1}}) {
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

// Spheres that shade each other, by lights of the sky and a sun, from two kinds of eyes: sums that come out on every machine, of
// any compiler.
TEST(Studio, HasTheSameBytesEverywhere) {
    std::string scene = "[light]\nsun = [0.6, 0.7, -1]\nsun_strength = 0.8\n";
    for (int i = 0; i < 40; ++i) {
        const auto at = [i](int factor, int below) { return std::to_string(i * factor % below - below / 2); };
        scene += "[[sphere]]\ncenter = [" + at(37, 101) + ", " + at(53, 83) + ", " + std::to_string(150 + i * 29 % 61) +
                 "]\nradius = " + std::to_string(4 + i % 13) + "\ncolor = [" + std::to_string(60 + i * 4) + ", 160, " +
                 std::to_string(220 - i * 3) + "]\n";
    }
    const std::vector<std::string> options = {"-s", "160x120", "--shade", "studio", "--samples", "4"};
    const auto sum = [&](std::vector<std::string> more) {
        more.insert(more.end(), options.begin(), options.end());
        return sha256(picture_of(scene, "cpu", more).bytes);
    };
    EXPECT_EQ(sum({}), "7e6cbcf4d68b7d106549ee56348f0ac36c4053ac10d3a173fa3566453eb42253");
    EXPECT_EQ(sum({"--lights", "100", "--projection", "orthographic"}),
              "e260e99ed5865a193c7a993ab801021cc535ecfe69b99d6b4526f8630d5df6c1");
    EXPECT_EQ(sum({"--sky", "0"}), "9f685c5b4bf58f7586aa6c2daba67deb36f6b2647f8ffddf4e95d51939f9639b");
}

// Over the finished picture, and nowhere else; the same bytes with any backend and any samples around them.
TEST(Marks, AreDrawnInTheCornersInWholeNumbers) {
    const std::vector<std::string> size = {"-s", "400x300"};
    const auto with = [&](std::vector<std::string> options) {
        options.insert(options.end(), size.begin(), size.end());
        return picture_of(red_scene, "cpu", options);
    };
    const Picture plain = with({});
    const auto differs = [&](const Picture& picture, int left, int right) {
        int count = 0;
        for (int y = 0; y < 300; ++y) {
            for (int x = left; x < right; ++x) count += picture.at(x, y) == plain.at(x, y) ? 0 : 1;
        }
        return count;
    };
    const Picture axes = with({"--axes"});
    EXPECT_GT(differs(axes, 0, 64), 500);
    EXPECT_EQ(differs(axes, 64, 400), 0);
    const Picture bar = with({"--scale-bar"});
    EXPECT_GT(differs(bar, 300, 400), 200);
    EXPECT_EQ(differs(bar, 0, 240), 0);
    const Picture both = with({"--axes", "--scale-bar"});
    EXPECT_EQ(differs(both, 0, 400), differs(axes, 0, 400) + differs(bar, 0, 400));
    EXPECT_EQ(picture_of(red_scene, "auto", {"--axes", "--scale-bar", "-s", "400x300"}), both);
    // A true length: 50 at the sphere's depth, where the picture's shorter side shows 200, are a quarter of that.
    int white = 0;
    for (int x = 300; x < 400; ++x) white += bar.at(x, 288) == std::vector<int>{245, 246, 248} ? 1 : 0;
    EXPECT_NEAR(white, 75, 3);
    // They take a third of a picture's side, at most; one where they would take more has none.
    EXPECT_NE(picture_of(red_scene, "cpu", {"-s", "300x192", "--axes"}), picture_of(red_scene, "cpu", {"-s", "300x192"}));
    for (const char* size : {"40x40", "191x1000"}) {
        EXPECT_EQ(picture_of(red_scene, "cpu", {"-s", size, "--axes", "--scale-bar"}), picture_of(red_scene, "cpu", {"-s", size}))
            << size;
    }
}

TEST(Marks, HaveTheSameBytesEverywhere) {
    const TemporaryFolder folder;
    folder.write("scene.txt", red_scene);
    const Outcome outcome = render(folder, {"scene.txt", "-s", "640x480", "--axes", "--scale-bar", "--view", "iso", "-o", "-"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(sha256(decode_png(outcome.output).bytes), "58e8d1a78a8a6fdc0cb1a61168425ebaaad701c34a2021fe9bd220eed5c59e6a");
}

// Near the end of what doubles hold nothing is lost: neither the fitted camera nor the shading underflows.
TEST(Fit, TinyScenesLookAsOthersDo) {
    const std::string scene = "2\n255 0 0\n0 0 5@\n1@\n0 255 0\n2@ 0 6@\n1@\n";
    const auto of_size = [&](const std::string& exponent) {
        std::string sized = scene;
        for (std::size_t at = sized.find('@'); at != std::string::npos; at = sized.find('@')) sized.replace(at, 1, exponent);
        return sized;
    };
    for (const char* mode : {"flat", "headlight", "normal", "depth"}) {
        const std::vector<std::string> options = {"--fit", "-s", "60x40", "--shade", mode};
        EXPECT_EQ(picture_of(of_size("e-300"), "cpu", options), picture_of(of_size(""), "cpu", options)) << mode;
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
        {"vulkan", {}, "SPHEREVIEW_BACKEND: found 'vulkan', expected auto, egl, osmesa, wgl or cpu", 2},
        {"cpu", {"--backend", "vulkan"}, "--backend: found 'vulkan', expected auto, egl, osmesa, wgl or cpu", 2},
    };
    for (const auto& [variable, options, said, status] : cases) {
        const Outcome outcome = run({.arguments = all_words({"render", "scene.txt", "-s", "5x5", "--verbose"}, options),
                                     .folder = folder.path(),
                                     .environment = {{"SPHEREVIEW_BACKEND", variable}}});
        EXPECT_EQ(outcome.status, status) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
    }
}

const std::string overlapping = "3  255 0 0  0 0 200 41  0 0 250  40 3 150 30  0 255 7  -20 -25 120 12";

std::string size_text(int width, int height) { return std::to_string(width) + "x" + std::to_string(height); }

// What --samples must make of the scene: the picture of `side` times the size, averaged.
Picture expected(const std::string& background, int width, int height, int side) {
    return averaged(picture_of(overlapping, "cpu", {"-s", size_text(width * side, height * side), "--background", background}),
                    side);
}

TEST(Samples, AreTheAverageOfALargerPicture) {
    for (const auto& [samples, side] : {std::pair{"1", 1}, {"4", 2}, {"16", 4}}) {
        for (const char* background : {"#102030", "transparent"}) {
            SCOPED_TRACE(std::string(samples) + " " + background);
            for (const auto& [width, height] : {std::pair{50, 41}, {1, 1}, {301, 1}, {1, 97}}) {
                const Picture picture = picture_of(
                    overlapping, "cpu", {"-s", size_text(width, height), "--background", background, "--samples", samples});
                EXPECT_EQ(picture, expected(background, width, height, side)) << width << " x " << height;
            }
        }
    }
}

// Such a picture is traced in several columns of blocks.
TEST(Samples, OfAPictureWiderThanABlock) {
    EXPECT_EQ(picture_of(overlapping, "cpu", {"-s", "200001x1", "--samples", "4"}), expected("black", 200'001, 1, 2));
}

TEST(Samples, AreReported) {
    const TemporaryFolder folder;
    folder.write("red.txt", red_scene);
    const Outcome outcome = render(folder, {"red.txt", "-s", "5x4", "--samples", "16", "--json", "--verbose"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    const auto report = Json::parse(outcome.output);
    EXPECT_EQ(report["samples"], 16);
    EXPECT_EQ(report["size"], Json({5, 4}));
    EXPECT_EQ(report["decided"]["float"], 5 * 4 * 16);
    EXPECT_TRUE(contains(outcome.errors, "red.txt: points (16 a pixel) decided: 320 in float, 0 in double, 0 exactly"));
    EXPECT_TRUE(contains(outcome.errors, "tiles of 8 points, "));
    EXPECT_EQ(Json::parse(render(folder, {"red.txt", "-s", "5x4", "--json"}).output)["samples"], 1);
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

TEST(Shade, IsComparedAndReported) {
    const TemporaryFolder folder;
    folder.write("scene.txt", red_scene);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--shade", "normal", "--samples", "4", "-o", "golden.png"}).status, 0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--shade", "normal", "--samples", "4", "--expect", "golden.png"}).status,
              0);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--samples", "4", "--expect", "golden.png"}).status, 1);
    EXPECT_EQ(render(folder, {"scene.txt", "-s", "50x50", "--shade", "normal", "--expect", "golden.png"}).status, 1);
    const Outcome outcome = render(folder, {"scene.txt", "-s", "9x9", "--shade", "id", "--json", "--verbose"});
    EXPECT_EQ(Json::parse(outcome.output).at("shade"), "id");
    EXPECT_NE(outcome.errors.find("; shaded: id"), std::string::npos) << outcome.errors;
}

// Red at +x, green at +y, blue at -z, equally far from 0, and a grey one behind all at the other ends.
constexpr const char* corner =
    "6\n255 0 0 4 0 0 1\n0 255 0 0 4 0 1\n0 0 255 0 0 -4 1\n9 9 9 -4 0 0 1\n9 9 9 0 -4 0 1\n9 9 9 0 0 4 1\n";
// The same as XYZ, with elements.
constexpr const char* molecule = "3\n\nO 100 100 100\nH 101 100 100\nH 100 101 100\n";

Picture seen(const std::string& scene, std::vector<std::string> options) {
    options.insert(options.end(), {"-s", "101x101"});
    return picture_of(scene, "cpu", options);
}

TEST(View, ShowsItsSide) {
    struct Case {
        std::string view;
        Pixel middle, right, top;
    };
    const Pixel grey = {9, 9, 9};
    const std::vector<Case> cases = {{"front", blue, red, green}, {"right", red, grey, green},  {"back", grey, grey, green},
                                     {"left", grey, blue, green}, {"top", green, red, grey},    {"bottom", grey, red, blue},
                                     {"90,0", red, grey, green},  {"-90,0", grey, blue, green}, {"0,-90", grey, red, blue}};
    for (const auto& [view, middle, right, top] : cases) {
        const Picture picture = seen(corner, {"--view", view});
        EXPECT_EQ(picture.at(50, 50), middle) << view;
        EXPECT_EQ(picture.at(92, 50), right) << view;
        EXPECT_EQ(picture.at(50, 8), top) << view;
        for (int i = 0; i < 101; ++i) {
            for (const auto& [x, y] : {std::pair{i, 0}, {i, 100}, {0, i}, {100, i}}) EXPECT_EQ(picture.at(x, y), black) << view;
        }
    }
}

TEST(SavedViews, AreSeenByTheirName) {
    const std::string views =
        "[[view]]\nname = 'from x'\neye = [900, 0, 0]\ncenter = [800, 0, 0]\nright = [0, 0, 50]\nup = [0, 50, 0]\n"
        "[[view]]\nname = 'flat'\neye = [0, 0, -900]\ncenter = [0, 0, -800]\nprojection = 'orthographic'\n";
    const auto scene = [&](const std::string& camera) { return camera + "spheres = '''" + std::string(corner) + "'''\n" + views; };
    const std::string from_x = "camera = {eye = [900, 0, 0], center = [800, 0, 0], right = [0, 0, 50], up = [0, 50, 0]}\n";
    EXPECT_EQ(seen(scene(""), {"--view", "from x"}), seen(scene(from_x), {}));
    EXPECT_NE(seen(scene(""), {"--view", "from x"}), seen(scene(""), {}));
    EXPECT_EQ(seen(scene(from_x), {"--view", "flat", "--projection", "perspective"}),
              seen(scene("camera = {eye = [0, 0, -900], center = [0, 0, -800]}\n"), {}));
    EXPECT_EQ(seen(scene(""), {"--view", "top"}), seen(corner, {"--view", "top"}));

    // Kept, and the camera of what is written.
    const Outcome converted = run({.arguments = {"convert", "-", "-", "--to", "toml", "--view", "from x"}, .input = scene("")});
    EXPECT_EQ(converted.status, 0) << converted;
    EXPECT_EQ(seen(converted.output, {}), seen(scene(from_x), {}));
    EXPECT_EQ(seen(converted.output, {"--view", "flat"}), seen(scene(""), {"--view", "flat"}));

    const auto refusal = [&](const std::string& text, const std::string& view) {
        const Outcome outcome = run({.arguments = {"render", "-", "-o", "-", "--view", view}, .input = text});
        EXPECT_EQ(outcome.status, 2) << outcome;
        return outcome.errors;
    };
    EXPECT_EQ(refusal(scene(""), "form x"),
              "stdin: found no view 'form x', expected one of its saved views, 'from x', 'flat', or front, back, left, "
              "right, top, bottom, iso or AZIMUTH,ELEVATION in degrees; did you mean 'from x'?\n");
    EXPECT_EQ(refusal(corner, "botom"),
              "stdin: found no view 'botom', expected front, back, left, right, top, bottom, iso or AZIMUTH,ELEVATION in "
              "degrees; it has no saved views; did you mean 'bottom'?\n");
}

TEST(Fit, IsForThoseWhoAskAndForDataWithoutACamera) {
    const std::string off_screen = "1\n255 0 0 5000 0 -200 20\n";
    EXPECT_EQ(seen(off_screen, {}).at(50, 50), black);
    EXPECT_EQ(seen(off_screen, {"--fit"}).at(50, 50), red);
    EXPECT_EQ(seen(off_screen, {"--no-fit"}).at(50, 50), black);
    const Picture fitted = seen(molecule, {});
    EXPECT_NE(fitted.at(50, 50), black);
    EXPECT_EQ(fitted, seen(molecule, {"--fit"}));
    EXPECT_EQ(fitted, seen(molecule, {"--view", "front"}));
    EXPECT_NE(fitted, seen(molecule, {"--no-fit"}));
    // Written as TOML, it is seen as it was; text holds no camera, and that is worth a word only if one was asked for.
    Command convert{.arguments = {"convert", "-", "-", "--to", "toml"}, .input = molecule};
    EXPECT_EQ(seen(run(convert).output, {}), fitted);
    convert.arguments.back() = "text";
    EXPECT_EQ(run(convert).errors, "stdin: the text format cannot hold the names (3); left out\n");
    convert.arguments.emplace_back("--fit");
    EXPECT_EQ(run(convert).errors, "stdin: the text format cannot hold the camera, the names (3); left out\n");
    // Nothing to see: as without.
    EXPECT_EQ(seen("0", {"--fit"}).at(50, 50), black);
    // A scene's own camera says from where: here from +x.
    const std::string from_x = "camera = {eye = [9, 0, 0], center = [8, 0, 0], right = [0, 0, 1], up = [0, 1, 0]}\nspheres = '''" +
                               std::string(corner) + "'''";
    EXPECT_EQ(seen(from_x, {"--fit"}), seen(corner, {"--view", "right"}));
    EXPECT_EQ(seen(from_x, {"--view", "top"}), seen(corner, {"--view", "top"}));
}

TEST(Fit, IsWhatConvertWritesAndWhatExplainExplains) {
    const TemporaryFolder folder;
    for (const std::string view : {"iso", "33,-12"}) {
        const Outcome scene = run({.arguments = {"convert", "-", "-", "--to", "toml", "--view", view}, .input = corner});
        ASSERT_EQ(scene.status, 0) << scene;
        const Picture picture = seen(corner, {"--view", view});
        EXPECT_EQ(picture, seen(scene.output, {})) << view;
        for (const auto& [x, y] : {std::pair{50, 20}, {70, 60}, {30, 64}, {50, 50}, {0, 0}}) {
            const std::string pixel = std::to_string(x) + "," + std::to_string(y);
            const Outcome outcome =
                run({.arguments = {"explain", "-", "--view", view, "-s", "101x101", "--pixel", pixel, "--json"}, .input = corner});
            ASSERT_EQ(outcome.status, 0) << outcome;
            EXPECT_EQ(Json::parse(outcome.output).at("color").get<Pixel>(), picture.at(x, y)) << view << pixel;
        }
    }
}

}  // namespace
}  // namespace sphereview::test

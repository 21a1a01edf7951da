// What --fit, --no-fit and --view do to a picture.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

using Pixel = std::vector<int>;
const Pixel red = {255, 0, 0};
const Pixel green = {0, 255, 0};
const Pixel blue = {0, 0, 255};
const Pixel black = {0, 0, 0};

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
    const Picture iso = seen(corner, {"--view", "iso"});
    int reds = 0;
    int greens = 0;
    int blues = 0;
    for (int y = 0; y < 101; ++y) {
        for (int x = 0; x < 101; ++x) {
            reds += iso.at(x, y) == red && x > 50 && y > 50 ? 1 : 0;
            blues += iso.at(x, y) == blue && x < 50 && y > 50 ? 1 : 0;
            greens += iso.at(x, y) == green && y < 50 ? 1 : 0;
        }
    }
    EXPECT_GT(reds, 50);
    EXPECT_NEAR(reds, blues, 10);
    EXPECT_NEAR(reds, greens, 40);
}

TEST(View, WithBadWordsIsRefusedBeforeAnyWork) {
    const TemporaryFolder folder;
    for (const char* view : {"side", "90", "90,", "0,91", "x,y", "inf,0"}) {
        const Outcome outcome = render(folder, {"missing.txt", "--view", view});
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with("sphereview: --view: found '" + std::string(view) +
                                               "', expected front, back, left, right, top, bottom, iso or AZIMUTH,ELEVATION"))
            << outcome;
    }
    for (const std::string option : {"--fit", "--view"}) {
        const Outcome outcome = render(folder, {"missing.txt", option + (option == "--view" ? "=top" : ""), "--no-fit"});
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, option) && contains(outcome.errors, "excludes")) << outcome;
    }
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
    Command convert;
    convert.arguments = {"convert", "-", "-", "--to", "toml"};
    convert.input = molecule;
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
        Command convert;
        convert.arguments = {"convert", "-", "-", "--to", "toml", "--view", view};
        convert.input = corner;
        const Outcome scene = run(convert);
        ASSERT_EQ(scene.status, 0) << scene;
        const Picture picture = seen(corner, {"--view", view});
        EXPECT_EQ(picture, seen(scene.output, {})) << view;
        for (const auto& [x, y] : {std::pair{50, 20}, {70, 60}, {30, 64}, {50, 50}, {0, 0}}) {
            Command explain;
            explain.arguments = {
                "explain", "-", "--view", view, "-s", "101x101", "--pixel", std::to_string(x) + "," + std::to_string(y), "--json"};
            explain.input = corner;
            const Outcome outcome = run(explain);
            ASSERT_EQ(outcome.status, 0) << outcome;
            EXPECT_EQ(nlohmann::json::parse(outcome.output).at("color").get<Pixel>(), picture.at(x, y)) << view << x << "," << y;
        }
    }
}

}  // namespace
}  // namespace sphereview::test

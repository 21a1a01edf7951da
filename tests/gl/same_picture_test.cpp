// Every renderer gives the same bytes.
#include <gtest/gtest.h>

#include <random>

#include "support/render.hpp"

namespace sphereview::test {
namespace {

struct Case {
    std::string name;
    std::string scene;
    std::string size;
};

std::ostream& operator<<(std::ostream& stream, const Case& test) { return stream << test.name; }

// `count` spheres between the eye and far away, some beside the picture.
std::string random_spheres(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::string text = std::to_string(count) + "\n";
    const auto number = [&](int low, int high) {
        return std::to_string(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1))) + " ";
    };
    for (int i = 0; i < count; ++i) {
        text += number(0, 255) + number(0, 255) + number(0, 255) + "\n";
        text += number(-200, 200) + number(-200, 200) + number(-100, 500) + "\n" + number(1, 60) + "\n";
    }
    return text;
}

// Before the eye, over a picture that is 42 times as wide as high; or, with x and y swapped, as high as wide.
std::string band_of_spheres(int count, bool upright) {
    std::mt19937 random(5);
    std::string text = std::to_string(count) + "\n";
    const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
    for (int i = 0; i < count; ++i) {
        const int z = 100 + below(400);
        const std::string along = std::to_string(z * (below(4301) - 2150) / 100);
        const std::string across = std::to_string(z * (below(141) - 70) / 100);
        text += std::to_string(i % 256) + " " + std::to_string(i / 256) + " 200\n";
        text += (upright ? across + " " + along : along + " " + across) + " " + std::to_string(z) + "\n";
        // Now and then one that covers many tiles.
        text += std::to_string(i % 100 == 0 ? 50 + below(500) : 1 + below(12)) + "\n";
    }
    return text;
}

const std::string three_spheres = R"(
[[sphere]]
name = "big"
color = [200, 30, 40]
center = [0, 0, 300]
radius = 90
[[sphere]]
color = [1, 255, 3]
center = [40, 25.5, 180]
radius = 20
[[sphere]]
color = [0, 0, 255]
center = [-30, 10, 150]
radius = 35
)";

const std::vector<Case> cases = {
    {"NoSpheres", "0", "31x17"},
    {"OnePixel", "1 9 8 7 0 0 200 20", "1x1"},
    {"OnePixelHigh", three_spheres, "640x1"},
    {"OnePixelWide", three_spheres, "1x333"},
    {"OddSize", three_spheres, "641x479"},
    {"Wide", three_spheres, "1000x100"},
    {"Tall", three_spheres, "100x1000"},
    {"WiderThanABlock", three_spheres, "2100x50"},
    {"HigherThanABlock", three_spheres, "50x2100"},
    {"TilesAcrossBlocks", band_of_spheres(5000, false), "2100x50"},
    {"TilesDownBlocks", band_of_spheres(5000, true), "50x2100"},
    {"Background", "background = '#0a141e'" + three_spheres, "100x80"},
    {"Transparent", "background = 'transparent'" + three_spheres, "100x80"},
    {"Hidden", three_spheres + "hidden = true\n[[sphere]]\ncolor = [9, 9, 9]\ncenter = [0, -20, 140]\nradius = 9", "200x200"},
    {"AllHidden", "[[sphere]]\ncolor = [9, 9, 9]\ncenter = [0, 0, 140]\nradius = 9\nhidden = true", "20x20"},
    {"EyeInside", "2 10 20 30 0 5 10 100 255 255 0 10 0 60 15", "99x99"},
    {"BehindTheEye", "2 10 20 30 0 0 -100 50 255 255 0 -40 0 -20 45", "99x99"},
    {"CrossingTheEyesPlane", "1 10 20 30 20 0 10 15", "99x99"},
    {"EqualSpheresTheFirstCounts", "2 1 1 1 0 0 200 30 2 2 2 0 0 200 30", "99x99"},
    {"Camera", "[camera]\neye = [30, 40, -20]\ncenter = [0, 10, 80]\nright = [0, 0, 40]\nup = [40, 0, 0]" + three_spheres,
     "301x200"},
    {"CameraOffTheAxis", "[camera]\ncenter = [60, -20, 100]\nright = [30, 30, 0]\nup = [-30, 30, 0]" + three_spheres, "301x200"},
    {"FarAway", "2 5 6 7 1e6 1e6 5e6 1e6 8 9 10 -1e9 0 4e9 5e8", "200x200"},
    {"HundredSpheres", random_spheres(100, 1), "400x300"},
    {"AsManyAsGuaranteed", random_spheres(1024, 2), "64x64"},
};

class SamePicture : public testing::TestWithParam<Case> {};

TEST_P(SamePicture, OnEveryBackend) {
    const auto& [name, scene, size] = GetParam();
    for (const char* samples : {"1", "4"}) {
        const std::vector<std::string> options = {"-s", size, "--samples", samples};
        const Picture expected = picture_of(scene, "cpu", options);
        EXPECT_EQ(std::to_string(expected.width) + "x" + std::to_string(expected.height), size);
        for (const char* backend : {"egl", "osmesa"}) {
            const Picture picture = picture_of(scene, backend, options);
            ASSERT_EQ(picture.bytes.size(), expected.bytes.size()) << backend;
            const auto [here, there] = std::mismatch(picture.bytes.begin(), picture.bytes.end(), expected.bytes.begin());
            if (here == picture.bytes.end()) continue;
            const auto pixel = (here - picture.bytes.begin()) / picture.channels;
            ADD_FAILURE() << backend << " differs from cpu with " << samples << " samples, first at pixel " << pixel % picture.width
                          << "," << pixel / picture.width;
        }
    }
}

// Light falls on what is visible, whoever found that; also where a picture has several batches of points.
TEST(SameLight, OnEveryBackend) {
    const std::string scene = "[light]\nlights = 24\nsky = 0.7\nsun = [-1, 2, -1]\nsun_strength = 0.5" + three_spheres;
    const std::vector<std::vector<std::string>> pictures = {
        {"-s", "301x200"}, {"-s", "301x200", "--samples", "16"}, {"-s", "1300x1000", "--lights", "16"}};
    for (std::vector<std::string> options : pictures) {
        options.insert(options.end(), {"--shade", "studio"});
        const Picture expected = picture_of(scene, "cpu", options);
        for (const char* backend : {"egl", "osmesa"})
            EXPECT_TRUE(picture_of(scene, backend, options).bytes == expected.bytes) << backend;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamePicture, testing::ValuesIn(cases), [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace sphereview::test

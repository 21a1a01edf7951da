// A lit picture that grows: how it begins, and that it never is darker than it ends.
#include "viewer/picture_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "exact/resolve.hpp"
#include "support/shaded_scenes.hpp"

namespace sphereview {

namespace {

struct Shown {
    double mean = 0.0;  // of all bytes
    std::int64_t black = 0;
};

Shown facts_of(const Image& picture) {
    Shown shown;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::uint8_t* rgb = picture.at(x, y);
            const int sum = rgb[0] + rgb[1] + rgb[2];
            shown.mean += sum;
            shown.black += sum == 0 ? 1 : 0;
        }
    }
    shown.mean /= 3.0 * picture.width() * picture.height();
    return shown;
}

}  // namespace

// Two lights alone leave much of a picture black, which had none as long as it moved.
TEST(LitDraft, GrowsDarkerFromThePictureThatMoved) {
    Scene scene = shaded_scene(1500, 3);
    for (Sphere& sphere : scene.spheres) sphere.color = {200, 150, 100};
    const PictureOptions options{.camera = scene.camera,
                                 .size = {240, 180},
                                 .background = {{20, 20, 20}, false},
                                 .samples = 16,
                                 .shading = Shading::studio,
                                 .light = {.lights = 1024, .sky = {}, .key = 1.0, .sun = {}, .toward_key = {}}};
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Resolver resolver(scene, drawn, options.size);
    std::vector<std::int32_t> seen;
    for (int y = 0; y < options.size.height; ++y) {
        for (int x = 0; x < options.size.width; ++x) {
            DecisionLevel level{};
            seen.push_back(resolver.resolve({x, y}, level));
        }
    }
    std::vector<Shown> shown;
    const Image last = lit_draft(scene, options, seen, [&](const Image& image) { shown.push_back(facts_of(image)); });
    const Shown end = facts_of(last);
    ASSERT_GE(shown.size(), 2U);
    EXPECT_EQ(shown.back().mean, end.mean);
    EXPECT_GT(shown.front().mean, end.mean);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        EXPECT_LE(shown[i].black, end.black) << i;
        if (i > 0) {
            EXPECT_LE(shown[i].mean, shown[i - 1].mean + 0.5) << i;
        }
    }
}

}  // namespace sphereview

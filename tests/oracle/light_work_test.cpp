// How much work light takes where it is hard.
#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "exact/resolve.hpp"
#include "light/lighting.hpp"
#include "oracle/light_oracle.hpp"
#include "oracle/light_scenes.hpp"
#include "oracle/oracle.hpp"
#include "oracle/random.hpp"

namespace sphereview::oracle {

namespace {

TEST(Light, of_hard_scenes_needs_few_integers) {
#ifdef VARIANT
    constexpr int spheres = 120;  // the slow build among them takes as long as the usual one
#else
    constexpr int spheres = 600;
#endif
    constexpr int lights = 16;
    constexpr PictureSize size{25, 25};
    for (const Trial& trial : hard_to_light(spheres, size)) {
        const Scene& scene = trial.scene;
        const DrawnSpheres drawn = drawn_spheres(scene);
        std::vector<std::int32_t> visible(25 * 25, doubtful_background);
        Resolver(scene, drawn, size).certify({0, 0, size.width, size.height}, visible);
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
        LightCounts counts;
        const std::vector<LightVector> found =
            lighting.light({0, 0, size.width, size.height}, visible, nullptr, nullptr, nullptr, &counts);
        std::cout << trial.name << ": " << counts.doubts << " doubts, " << counts.in_integers << " in integers\n";
        // Each point of each light is asked of far fewer spheres than there are, and integers of hardly any.
        EXPECT_LT(counts.doubts, 1000 * spheres) << trial.name;
        EXPECT_LT(counts.in_integers, 10 * spheres) << trial.name;
        Random random(seed());
        std::vector<glm::dvec3> directions;
        for (const DirectedLight& light : lighting.lights(0)) directions.push_back(light.direction);
        for (int i = 0; i < 3 && is_sampled(1); ++i) {
            const Pixel at{i < 1 ? 12 : random.whole(0, 24), i < 1 ? 12 : random.whole(0, 24)};
            const auto place = static_cast<std::size_t>(at.y * size.width + at.x);
            if (visible[place] < 0) continue;
            const std::vector<bool> shining = shines(scene, size, at, visible[place], directions);
            LightVector expected;
            for (std::size_t k = 0; k < shining.size(); ++k) {
                if (shining[k]) expected += lighting.lights(0)[k].share;
            }
            EXPECT_EQ(found[place], expected) << trial.name << ", " << at.x << "," << at.y;
        }
    }
}

// Of the amount of work other flags of the compiler (flags/) say the same; and sanitizers, with which it takes long, find nothing
// that they do not find above.
#if !defined(VARIANT) && !defined(SPHEREVIEW_SANITIZED)

// What is far away or huge makes float and double ask no more than it must: nearly all is decided for all points at once.
TEST(Light, work_is_bounded_whatever_is_around) {
    constexpr int others = 300;
    constexpr int lights = 16;
    constexpr PictureSize size{60, 60};
    for (const Surroundings& around : surroundings(200, others)) {
        const Scene& scene = around.scene;
        const std::vector<std::int32_t> visible = picture(scene, size);
        const DrawnSpheres drawn = drawn_spheres(scene);
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
        LightCounts counts;
        lighting.light({0, 0, size.width, size.height}, visible, nullptr, nullptr, nullptr, &counts);
        EXPECT_GT(counts.points_facing, 1000) << around.name;
        EXPECT_LT(counts.doubts, 2 * lights * others) << around.name;
    }
}

#endif

}  // namespace

}  // namespace sphereview::oracle

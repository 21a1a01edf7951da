// What is written is read back the same, bit for bit. SPHEREVIEW_SEED=N tries other scenes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "formats/scene_format.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

namespace {

constexpr int trials = 500;

std::uint64_t seed() {
    const char* text = std::getenv("SPHEREVIEW_SEED");
    return text == nullptr ? 20240607 : std::strtoull(text, nullptr, 10);
}

}  // namespace

TEST(RoundTrip, KeepsEveryBitOfRandomScenes) {
    std::cout << "SPHEREVIEW_SEED=" << seed() << "\n";
    int cameras = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::mt19937_64 random(seed() + static_cast<std::uint64_t>(trial));  // a trial's own, to be tried again alone
        const Scene scene = random_scene(random);
        if (scene.camera != Camera{}) ++cameras;

        const std::string toml = write_scene(scene, SceneFormat::toml);
        ASSERT_NO_THROW(EXPECT_EQ(difference(parse_scene(toml, "s.toml"), scene), ""))
            << "trial " << trial << " of SPHEREVIEW_SEED=" << seed() << " as TOML:\n"
            << toml;

        const std::string text = write_scene(scene, SceneFormat::text);
        ASSERT_NO_THROW(EXPECT_EQ(difference(parse_scene(text, "s.txt"), without_extras(scene)), ""))
            << "trial " << trial << " of SPHEREVIEW_SEED=" << seed() << " as text:\n"
            << text;

        if (HasFailure()) FAIL() << "trial " << trial << " of SPHEREVIEW_SEED=" << seed() << ":\n" << toml;
    }
    EXPECT_GT(cameras, trials / 20);  // else cameras were hardly tried
}

// The test above can only fail if this can.
TEST(RoundTrip, IsJudgedByEveryBit) {
    const auto changed = [](const auto& change) {
        Scene before;
        before.spheres.resize(2);
        Scene after = before;
        change(after);
        return difference(after, before);
    };
    EXPECT_EQ(changed([](Scene&) {}), "");
    EXPECT_EQ(changed([](Scene& s) { s.spheres[1].center.x = -0.0; }), "sphere 1.center[0]: -0x0p+0 instead of 0x0p+0");
    EXPECT_EQ(changed([](Scene& s) { s.camera.up.z = 1; }), "camera.up[2]: 0x1p+0 instead of 0x0p+0");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].radius = 20.000000000000004; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].color.b = 0; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].hidden = true; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres.pop_back(); }), "");
    EXPECT_NE(changed([](Scene& s) { s.names[0] = "x"; }), "");
    EXPECT_NE(changed([](Scene& s) { s.background.transparent = true; }), "");
}

}  // namespace sphereview

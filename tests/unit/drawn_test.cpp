#include "exact/drawn.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/visible.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::int32_t>;

Scene five_spheres(const std::vector<std::size_t>& hidden) {
    Scene scene;
    scene.spheres.resize(5);
    for (std::size_t i = 0; i < 5; ++i) scene.spheres[i].radius = static_cast<double>(i + 1);
    for (const std::size_t number : hidden) scene.spheres[number].hidden = true;
    return scene;
}

}  // namespace

TEST(DrawnSpheres, AreAllWhereNothingIsHidden) {
    const Scene scene = five_spheres({});
    const DrawnSpheres drawn = drawn_spheres(scene);
    EXPECT_EQ(count_drawn(scene), 5U);
    EXPECT_EQ(drawn.center_radius.size(), 5U);
    EXPECT_TRUE(drawn.numbers.empty());
    Numbers visible = {4, visible_background, 0};
    to_scene_numbers(drawn, visible);
    EXPECT_EQ(visible, (Numbers{4, visible_background, 0}));
}

TEST(DrawnSpheres, KeepTheirNumbersInTheScene) {
    const Scene scene = five_spheres({0, 3});
    const DrawnSpheres drawn = drawn_spheres(scene);
    EXPECT_EQ(count_drawn(scene), 3U);
    ASSERT_EQ(drawn.center_radius.size(), 3U);
    EXPECT_EQ(drawn.center_radius[0].w, 2.0F);
    EXPECT_EQ(drawn.center_radius[2].w, 5.0F);
    Numbers visible = {0, 1, visible_background, 2};
    to_scene_numbers(drawn, visible);
    EXPECT_EQ(visible, (Numbers{1, 2, visible_background, 4}));
}

TEST(DrawnSpheres, AreNoneWhereAllAreHidden) {
    const Scene scene = five_spheres({0, 1, 2, 3, 4});
    EXPECT_EQ(count_drawn(scene), 0U);
    EXPECT_TRUE(drawn_spheres(scene).center_radius.empty());
    Numbers visible = {visible_background};
    to_scene_numbers(drawn_spheres(scene), visible);
    EXPECT_EQ(visible, (Numbers{visible_background}));
}

TEST(DrawnSpheres, AreRelativeToTheEyeBeforeTheyAreRounded) {
    Scene scene = five_spheres({});
    scene.camera.eye = {1e9, 0, 0};
    scene.spheres[0].center = {1e9 + 0.125, 1, 2};
    EXPECT_EQ(drawn_spheres(scene).center_radius[0], glm::vec4(0.125F, 1, 2, 1));
}

TEST(RayFrame, RoundsNothingForTheDefaultCamera) {
    for (const PictureSize size : {PictureSize{1000, 1000}, {1, 1}, {333, 77}, {3, 16384}}) {
        const RayFrame frame = ray_frame({}, size);
        EXPECT_GE(frame.forward.z, 0.5F);
        EXPECT_LT(frame.forward.z, 1.0F);
        // forward : right is m 100 : 50, exactly.
        EXPECT_EQ(static_cast<double>(frame.forward.z), 2.0 * size.shorter_side() * static_cast<double>(frame.right.x));
        EXPECT_EQ(frame.right.x, frame.up.y);
        EXPECT_EQ(frame.forward.x, 0.0F);
    }
}

TEST(RayFrame, IsTheSameForACameraOfAnyScale) {
    const RayFrame usual = ray_frame({}, {1000, 1000});
    for (const int exponent : {-900, -100, 100, 1016}) {
        const auto scaled = [&](const glm::dvec3& v) {
            return glm::dvec3(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
        };
        const Camera usual_camera;
        const Camera camera{scaled(usual_camera.eye), scaled(usual_camera.center), scaled(usual_camera.right),
                            scaled(usual_camera.up)};
        const RayFrame frame = ray_frame(camera, {1000, 1000});
        EXPECT_EQ(frame.forward, usual.forward) << exponent;
        EXPECT_EQ(frame.right, usual.right) << exponent;
        EXPECT_EQ(frame.up, usual.up) << exponent;
    }
}

}  // namespace sphereview

#include "exact/drawn.hpp"
#include "support/spheres.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sphereview {

namespace {

// Five spheres of radius 1 to 5, some hidden.
Scene five_spheres(const std::vector<std::size_t>& hidden) {
    Scene scene = scene_of_alike(5);
    for (std::size_t i = 0; i < 5; ++i) scene.spheres[i].radius = static_cast<double>(i + 1);
    for (const std::size_t number : hidden) scene.spheres[number].hidden = true;
    return scene;
}

std::vector<std::int32_t> numbers(const Scene& scene) {
    const DrawnSpheres drawn = drawn_spheres(scene);
    std::vector<std::int32_t> numbers;
    for (std::size_t i = 0; i < drawn.size(); ++i) numbers.push_back(drawn.number(i));
    return numbers;
}

using Indices = std::vector<std::int32_t>;

}  // namespace

TEST(DrawnSpheres, KeepTheirNumbersInTheScene) {
    EXPECT_EQ(numbers(five_spheres({})), (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(numbers(five_spheres({0, 3})), (Indices{1, 2, 4}));
    EXPECT_EQ(numbers(five_spheres({0, 1, 2, 3, 4})), Indices{});
    EXPECT_EQ(drawn_spheres(five_spheres({0, 3})).center_radius[1].w, 3.0F);
}

TEST(DrawnSpheres, LeaveOutEachThatEqualsAnEarlierOne) {
    Scene scene = five_spheres({1});
    scene.spheres[2].radius = 2.0;       // as the hidden one: drawn
    scene.spheres[3].radius = 1.0;       // as the first, but
    scene.spheres[3].center.x = 5e-324;  // not quite
    scene.spheres[4].radius = 1.0;       // as the first,
    scene.spheres[4].center.y = -0.0;    // -0 is 0
    scene.spheres[4].color = {1, 2, 3};  // and colours do not count
    EXPECT_EQ(numbers(scene), (Indices{0, 2, 3}));
}

TEST(DrawnSpheres, AreRelativeToTheEyeBeforeTheyAreRounded) {
    Scene scene = five_spheres({});
    scene.camera.eye = {1e9, 0, 0};
    scene.spheres[0].center = {1e9 + 0.125, 3, 2};
    EXPECT_EQ(drawn_spheres(scene).center_radius[0], glm::vec4(0.125F, 3, 2, 1));
}

TEST(DrawnSpheres, KnowOnWhichSideTheEyeIs) {
    Scene scene = five_spheres({});
    scene.spheres[0].center = {1, 0, 0};
    scene.spheres[1].center = {1, 0, 0};
    const DrawnSpheres drawn = drawn_spheres(scene);
    EXPECT_EQ(drawn.side(0), EyeSide::on_surface);
    EXPECT_EQ(drawn.side(1), EyeSide::inside);
    EXPECT_EQ(drawn.side(2), EyeSide::outside);
}

TEST(RayBasis, RoundsNothingForTheDefaultCamera) {
    for (const PictureSize size : {PictureSize{1000, 1000}, {1, 1}, {333, 77}, {3, 16384}}) {
        const RayBasis<float> frame = ray_basis<float>({}, size);
        EXPECT_GE(frame.forward.z, 0.5F);
        EXPECT_LT(frame.forward.z, 1.0F);
        // forward : right is m 100 : 50, exactly.
        EXPECT_EQ(static_cast<double>(frame.forward.z), 2.0 * size.shorter_side() * static_cast<double>(frame.right.x));
        EXPECT_EQ(frame.right.x, frame.up.y);
        EXPECT_EQ(frame.forward.x, 0.0F);
    }
}

TEST(RayBasis, IsTheSameForACameraOfAnyScale) {
    const RayBasis<float> usual = ray_basis<float>({}, {1000, 1000});
    for (const int exponent : {-900, -100, 100, 1016}) {
        const auto scaled = [&](const glm::dvec3& v) {
            return glm::dvec3(std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent));
        };
        const Camera usual_camera;
        const Camera camera{scaled(usual_camera.eye), scaled(usual_camera.center), scaled(usual_camera.right),
                            scaled(usual_camera.up)};
        const RayBasis<float> frame = ray_basis<float>(camera, {1000, 1000});
        EXPECT_EQ(frame.forward, usual.forward) << exponent;
        EXPECT_EQ(frame.right, usual.right) << exponent;
        EXPECT_EQ(frame.up, usual.up) << exponent;
    }
}

}  // namespace sphereview

// What is drawn: cameras, backgrounds, bounds.
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "oracle/random.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

using Limits = std::numeric_limits<double>;

std::string fault(const Camera& camera) { return camera_fault(camera).value_or(CameraFault{"none", {}}).what; }

constexpr const char* in_plane = "'eye' lies in the screen's plane, or within 1e-6 of its distance from 'center'";

Camera scaled_default(double factor) {
    const Camera camera;
    return {camera.eye * factor, camera.center * factor, camera.right * factor, camera.up * factor};
}

}  // namespace

TEST(CameraFault, TakesTheDefaultAndItsRelatives) {
    EXPECT_EQ(fault({}), "none");
    EXPECT_EQ(fault({{1, 2, 3}, {1, 2, -3}, {0, 0, 7}, {7, 0, 0}}), in_plane);
    EXPECT_EQ(fault({{1, 2, 3}, {1, 20, 3}, {0, 0, 7}, {7, 0, 0}}), "none");
    EXPECT_EQ(fault({{0, 0, 0}, {500, 500, 100}, {50, 0, 0}, {0, 50, 0}}), "none");  // the centre far off the axis
    EXPECT_EQ(fault({{0, 0, 0}, {0, 0, 100}, {-50, 0, 0}, {0, 50, 0}}), "none");     // mirrored
}

TEST(CameraFault, TakesAnyScale) {
    for (const double factor : {1e300, 1e-300, 1e306, 1e-310, 0x1p-1040}) {
        EXPECT_EQ(fault(scaled_default(factor)), "none") << factor;
    }
    EXPECT_EQ(fault({{0, 0, -1.7e308}, {0, 0, 1.7e308}, {1e-300, 0, 0}, {0, 1e-300, 0}}), "none");
    EXPECT_EQ(fault({{0, 0, 0}, {0, 0, 1e-300}, {1e300, 0, 0}, {0, 1e300, 0}}), "none");
    const double largest = Limits::max();
    EXPECT_EQ(fault({{-largest, -largest, -largest}, {largest, largest, largest}, {largest, 0, 0}, {0, largest, 0}}), "none");
}

TEST(CameraFault, NamesWhatIsNotFinite) {
    for (const double bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
        for (glm::dvec3 Camera::*member : {&Camera::eye, &Camera::center, &Camera::right, &Camera::up}) {
            Camera camera;
            (camera.*member).y = bad;
            EXPECT_EQ(fault(camera), "its numbers are not all finite");
        }
    }
}

TEST(CameraFault, NamesWhatIsZeroOrFallsTogether) {
    EXPECT_EQ(fault({{0, 0, 0}, {0, 0, 100}, {0, -0.0, 0}, {0, 50, 0}}), "'right' is zero");
    EXPECT_EQ(fault({{0, 0, 0}, {0, 0, 100}, {50, 0, 0}, {0, 0, 0}}), "'up' is zero");
    EXPECT_EQ(fault({{0, 0, 100}, {0, 0, 100}, {50, 0, 0}, {0, 50, 0}}), "'eye' and 'center' are the same point");
}

TEST(CameraFault, AllowsAMillionthFromPerpendicularAndEquallyLong) {
    const auto with_up = [](const glm::dvec3& up) { return fault({{0, 0, 0}, {0, 0, 100}, {50, 0, 0}, up}); };
    EXPECT_EQ(with_up({50 * 0.9e-6, 50, 0}), "none");
    EXPECT_EQ(with_up({50 * 1.1e-6, 50, 0}), "'up' is not perpendicular to 'right'");
    EXPECT_EQ(with_up({50, 0, 0}), "'up' is not perpendicular to 'right'");
    for (const double length : {50 * (1 + 0.9e-6), 50 * (1 - 0.9e-6)}) EXPECT_EQ(with_up({0, length, 0}), "none") << length;
    for (const double length : {50 * (1 + 1.1e-6), 50 * (1 - 1.1e-6), 1e-300, 1e300, 5e-324}) {
        EXPECT_EQ(with_up({0, length, 0}), "'right' and 'up' are not equally long") << length;
    }
}

TEST(CameraFault, NamesAnEyeInTheScreensPlane) {
    EXPECT_EQ(fault({{9, 9, 100}, {0, 0, 100}, {50, 0, 0}, {0, 50, 0}}), in_plane);
    EXPECT_EQ(fault({{9, 9, 100 + 1e-9}, {0, 0, 100}, {50, 0, 0}, {0, 50, 0}}), in_plane);
    EXPECT_EQ(fault({{0, 0, 99.9995}, {1000, 0, 100}, {50, 0, 0}, {0, 50, 0}}), in_plane);
    EXPECT_EQ(fault({{0, 0, 99.9985}, {1000, 0, 100}, {50, 0, 0}, {0, 50, 0}}), "none");
    EXPECT_EQ(fault({{9, 9, 100.1}, {0, 0, 100}, {50, 0, 0}, {0, 50, 0}}), "none");
}

TEST(RayCoefficients, AreOddOrEvenWholeNumbersAroundTheCentre) {
    const PictureSize size{4, 3};
    EXPECT_EQ(ray_coefficients(size, {0, 0}).across, -3);
    EXPECT_EQ(ray_coefficients(size, {3, 0}).across, 3);
    EXPECT_EQ(ray_coefficients(size, {0, 0}).upward, 2);
    EXPECT_EQ(ray_coefficients(size, {0, 1}).upward, 0);
    EXPECT_EQ(ray_coefficients(size, {0, 2}).upward, -2);
}

TEST(Background, ReadsWhatItsSyntaxSays) {
    const std::vector<std::pair<const char*, Background>> cases = {
        {"black", {{0, 0, 0}, false}},       {"white", {{255, 255, 255}, false}},      {"transparent", {{0, 0, 0}, true}},
        {"#0080ff", {{0, 128, 255}, false}}, {"#ABCDEF", {{0xAB, 0xCD, 0xEF}, false}},
    };
    for (const auto& [text, expected] : cases) {
        Background background{{1, 2, 3}, true};
        EXPECT_TRUE(parse_background(text, background)) << text;
        EXPECT_EQ(background, expected) << text;
    }
}

TEST(Background, LeavesTheValueAloneWhenTheTextIsWrong) {
    for (const char* text : {"", "Black", "grey", "#fff", "#12345", "#1234567", "#12345g", "#-12345", "#+12345", "# 12345",
                             "#12 456", "123456", "#1-2-3-", "white "}) {
        Background background{{1, 2, 3}, true};
        EXPECT_FALSE(parse_background(text, background)) << text;
        EXPECT_EQ(background, (Background{{1, 2, 3}, true})) << text;
    }
}

TEST(Background, IsWrittenInItsShortestSpelling) {
    EXPECT_EQ(to_string(Background{}), "black");
    EXPECT_EQ(to_string(Background{{255, 255, 255}, false}), "white");
    EXPECT_EQ(to_string(Background{{0, 0, 0}, true}), "transparent");
    EXPECT_EQ(to_string(Background{{1, 0, 255}, false}), "#0100ff");
}

TEST(Bounds, AreWhatTheDefaultScreenShowsWhereNothingIs) {
    Scene scene;
    for (int i = 0; i < 2; ++i) {
        const SceneBounds bounds = bounds_of(scene);
        EXPECT_EQ(bounds.low, glm::dvec3(-100, -100, 100));
        EXPECT_EQ(bounds.high, glm::dvec3(100, 100, 300));
        EXPECT_EQ(bounds.middle(), glm::dvec3(0, 0, 200));
        EXPECT_EQ(bounds.extent(), 200.0);
        EXPECT_EQ(bounds.hidden, static_cast<std::size_t>(i));
        scene.spheres.push_back({{5, 5, 5}, 1.0, {}, true});  // hidden
    }
}

TEST(Bounds, HoldAllSpheresThatAreNotHidden) {
    oracle::Random random(1);
    for (const std::size_t count : {1, 2, 100, 50000}) {
        Scene scene;
        glm::dvec3 low(1e300);
        glm::dvec3 high(-1e300);
        double largest = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const Sphere sphere{random.in_cube(1000.0), random.of_size(1e-3, 1e3), {}, i > 0 && random.chance(0.3)};
            scene.spheres.push_back(sphere);
            if (sphere.hidden) continue;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], sphere.center[axis] - sphere.radius);
                high[axis] = std::max(high[axis], sphere.center[axis] + sphere.radius);
            }
            largest = std::max(largest, sphere.radius);
        }
        const SceneBounds bounds = bounds_of(scene);
        EXPECT_EQ(bounds.low, low);
        EXPECT_EQ(bounds.high, high);
        EXPECT_EQ(bounds.largest_radius, largest);
        EXPECT_EQ(bounds.hidden, static_cast<std::size_t>(std::ranges::count_if(scene.spheres, &Sphere::hidden)));
    }
}

TEST(Bounds, StayFiniteAndMoreThanNothing) {
    const double most = std::numeric_limits<double>::max();
    Scene scene = scene_of({{{most, 0, 0}, most, {}, false}, {{-most, 0, 0}, most, {}, false}});
    SceneBounds bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low.x, -most);
    EXPECT_EQ(bounds.high.x, most);
    EXPECT_EQ(bounds.middle().x, 0.0);
    EXPECT_EQ(bounds.extent(), most);
    scene.spheres = {{{1e9, 1e9, 1e9}, 1e-300, {}, false}};
    bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low, bounds.high);
    EXPECT_EQ(bounds.extent(), 2e-300);
}

}  // namespace sphereview

#include "scene/camera.hpp"

#include <gtest/gtest.h>

#include <limits>

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
    Camera camera;
    camera.right = {0, -0.0, 0};
    EXPECT_EQ(fault(camera), "'right' is zero");
    camera = {};
    camera.up = {};
    EXPECT_EQ(fault(camera), "'up' is zero");
    camera = {};
    camera.eye = camera.center;
    EXPECT_EQ(fault(camera), "'eye' and 'center' are the same point");
}

TEST(CameraFault, AllowsAMillionthFromPerpendicular) {
    Camera camera;
    camera.up = {50 * 0.9e-6, 50, 0};
    EXPECT_EQ(fault(camera), "none");
    camera.up = {50 * 1.1e-6, 50, 0};
    EXPECT_EQ(fault(camera), "'up' is not perpendicular to 'right'");
    camera.up = camera.right;
    EXPECT_EQ(fault(camera), "'up' is not perpendicular to 'right'");
}

TEST(CameraFault, AllowsAMillionthFromEquallyLong) {
    Camera camera;
    for (const double length : {50 * (1 + 0.9e-6), 50 * (1 - 0.9e-6)}) {
        camera.up = {0, length, 0};
        EXPECT_EQ(fault(camera), "none") << length;
    }
    for (const double length : {50 * (1 + 1.1e-6), 50 * (1 - 1.1e-6), 1e-300, 1e300, 5e-324}) {
        camera.up = {0, length, 0};
        EXPECT_EQ(fault(camera), "'right' and 'up' are not equally long") << length;
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

}  // namespace sphereview

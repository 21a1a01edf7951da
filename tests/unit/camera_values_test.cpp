#include "camera/camera_values.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "camera/fit.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

Camera seen(double azimuth, double elevation, Projection projection = Projection::perspective) {
    Scene scene = scene_of({Sphere{.center = {1.0, 2.0, 3.0}, .radius = 4.0}});
    return fitted(scene, axes_from(azimuth, elevation), projection).value();
}

// As data is seen.
Camera mirrored(double azimuth, double elevation) {
    Scene scene = scene_of({Sphere{.center = {1.0, 2.0, 3.0}, .radius = 4.0}});
    return fitted(scene, with_hand_of(data_axes, axes_from(azimuth, elevation))).value();
}

void expect_near(const Camera& a, const Camera& b, double tolerance) {
    for (const auto part : {&Camera::eye, &Camera::center, &Camera::right, &Camera::up}) {
        EXPECT_LT(glm::distance(a.*part, b.*part), tolerance);
    }
}

}  // namespace

TEST(CameraValues, AreTheDefaultCameras) {
    EXPECT_NEAR(field_of_view(Camera{}), 53.13010235415598, 1e-12);
    EXPECT_EQ(screen_side(Camera{}), 100.0);
    EXPECT_EQ(roll_of(Camera{}), 0.0);
}

TEST(CameraValues, NoViewOfASideIsRolled) {
    for (const double azimuth : {0.0, 30.0, 90.0, 180.0, 270.0}) {
        for (const double elevation : {-90.0, -60.0, 0.0, 45.0, 90.0}) {
            if (azimuth != 0.0 && (elevation == 90.0 || elevation == -90.0)) continue;  // those are turned about y
            EXPECT_NEAR(roll_of(seen(azimuth, elevation)), 0.0, 1e-9) << azimuth << " " << elevation;
            EXPECT_NEAR(roll_of(mirrored(azimuth, elevation)), 0.0, 1e-9) << azimuth << " " << elevation;
        }
    }
}

TEST(CameraValues, WhatIsSetIsThere) {
    for (const Camera& camera : {Camera{}, seen(30.0, 20.0), seen(0.0, 90.0), mirrored(200.0, -50.0), mirrored(0.0, 0.0)}) {
        for (const double degrees : {-179.0, -90.0, -12.5, 0.0, 1e-3, 90.0, 135.0}) {
            const Camera rolled = with_roll(camera, degrees);
            EXPECT_NEAR(roll_of(rolled), degrees, 1e-9);
            EXPECT_FALSE(camera_fault(rolled));
            EXPECT_EQ(camera_axes(rolled).mirrored, camera_axes(camera).mirrored);
            EXPECT_EQ(rolled.eye, camera.eye);
            expect_near(with_roll(rolled, roll_of(camera)), camera, 1e-9 * screen_side(camera));
        }
        for (const double degrees : {narrowest_view, 1.0, 53.0, 90.0, widest_view}) {
            const Camera wider = with_field_of_view(camera, degrees);
            EXPECT_NEAR(field_of_view(wider), degrees, 1e-9);
            EXPECT_FALSE(camera_fault(wider));
            EXPECT_EQ(wider.center, camera.center);
        }
        EXPECT_NEAR(screen_side(with_screen_side(camera, 3.0)), 3.0, 1e-12);
    }
    // Clockwise: what was up is at the left of the picture.
    EXPECT_EQ(with_roll(Camera{}, 90.0).up, glm::dvec3(50.0, 0.0, 0.0));
    EXPECT_EQ(with_roll(Camera{}, 90.0).right, glm::dvec3(0.0, -50.0, 0.0));
}

TEST(CameraValues, AMovedEyeLooksAtTheCentreAsBefore) {
    for (const Camera& before : {Camera{}, with_roll(seen(30.0, 20.0), 25.0), mirrored(200.0, -50.0)}) {
        const glm::dvec3 eye = before.eye + glm::dvec3(13.0, -7.0, 21.0);
        const Camera after = with_eye(before, eye);
        EXPECT_EQ(after.eye, eye);
        EXPECT_EQ(after.center, before.center);
        EXPECT_FALSE(camera_fault(after));
        EXPECT_NEAR(roll_of(after), roll_of(before), 1e-9);
        EXPECT_NEAR(field_of_view(after), field_of_view(before), 1e-9);
        EXPECT_LT(glm::distance(camera_axes(after).ahead, glm::normalize(after.center - after.eye)), 1e-12);
        EXPECT_EQ(camera_axes(after).mirrored, camera_axes(before).mirrored);
        expect_near(with_eye(after, before.eye), before, 1e-9 * screen_side(before));
        const Camera other = with_center(before, before.center + glm::dvec3(5.0, 3.0, -2.0));
        EXPECT_EQ(other.eye, before.eye);
        EXPECT_NEAR(roll_of(other), roll_of(before), 1e-9);
        EXPECT_NEAR(field_of_view(other), field_of_view(before), 1e-9);
        EXPECT_EQ(with_eye(before, before.eye), before) << "to the bit";
    }
    const Camera flat = seen(10.0, 10.0, Projection::orthographic);
    EXPECT_NEAR(screen_side(with_eye(flat, flat.eye * 3.0)), screen_side(flat), 1e-9);
}

TEST(CameraValues, AScreenAskewStaysAsItIs) {
    Camera askew;
    askew.center.x = 30.0;
    const Camera after = with_eye(askew, {1.0, 2.0, 3.0});
    EXPECT_EQ(after, (Camera{{1.0, 2.0, 3.0}, askew.center, askew.right, askew.up}));
    EXPECT_NEAR(field_of_view(askew), field_of_view(Camera{}), 1e-12);
}

TEST(CameraValues, AFaultIsTheCallers) {
    EXPECT_TRUE(camera_fault(with_eye(Camera{}, Camera{}.center)));
    EXPECT_TRUE(camera_fault(with_center(Camera{}, Camera{}.eye)));
}

}  // namespace sphereview

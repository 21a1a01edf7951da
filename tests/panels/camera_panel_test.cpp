// The panel of the camera: its numbers are the view's, and what is changed of them is the scene's.
#include <gtest/gtest.h>

#include <cmath>

#include "camera/camera_values.hpp"
#include "panels/harness.hpp"

namespace sphereview {

namespace {

struct OpenCameraPanel : OpenPartHarness {
    explicit OpenCameraPanel(const Camera& camera = {})
        : OpenPartHarness(
              "camera", [&](Scene& scene) { scene.camera = camera; }, 1100.0F) {}

    const Camera& camera() const { return document.scene().camera; }
};

}  // namespace

TEST(CameraPanel, ButtonsRunCommands) {
    OpenCameraPanel panel;
    panel.click("use view");
    panel.click("home");
    EXPECT_EQ(panel.commands_taken(), (std::vector{CommandId::use_view_as_camera, CommandId::go_home}));
}

TEST(CameraPanel, NumbersAreTyped) {
    OpenCameraPanel panel;
    panel.enter("eye x", "3*4");
    EXPECT_EQ(panel.camera().eye, glm::dvec3(12.0, 0.0, 0.0));
    EXPECT_EQ(panel.document.undo_name(), "Move the camera's eye");
    EXPECT_NEAR(field_of_view(panel.camera()), field_of_view(Camera{}), 1e-9);
    panel.enter("centre y", "-5");
    EXPECT_EQ(panel.camera().center, glm::dvec3(0.0, -5.0, 100.0));
    panel.enter("field of view", "90");
    EXPECT_NEAR(field_of_view(panel.camera()), 90.0, 1e-9);
    panel.enter("roll", "45");
    EXPECT_NEAR(roll_of(panel.camera()), 45.0, 1e-9);
    EXPECT_EQ(panel.document.undo_name(), "Roll the camera");
    for (int i = 0; i < 4; ++i) panel.undo();
    EXPECT_EQ(panel.camera(), Camera{});
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(CameraPanel, ADragIsOneStepAndThereAndBackIsNone) {
    for (const std::string number : {"eye x", "eye z", "centre y", "field of view", "roll"}) {
        SCOPED_TRACE(number);
        OpenCameraPanel panel;
        panel.drag_by(number, 23.0F);
        EXPECT_NE(panel.camera(), Camera{});
        EXPECT_FALSE(camera_fault(panel.camera()));
        panel.undo();
        EXPECT_EQ(panel.camera(), Camera{});
        EXPECT_FALSE(panel.document.can_undo());
        const ImVec2 from = panel.place("slider " + number);
        panel.move(from);
        panel.press();
        for (const float x : {20.0F, -30.0F, 11.0F, 0.0F}) panel.move({from.x + x, from.y});
        panel.release();
        EXPECT_TRUE(same_bits(panel.camera(), Camera{}));
        EXPECT_FALSE(panel.document.can_undo());
    }
    OpenCameraPanel panel;
    panel.drag_by("field of view", 900.0F);
    EXPECT_NEAR(field_of_view(panel.camera()), widest_view, 1e-9);
    panel.drag_by("field of view", -900.0F);
    EXPECT_NEAR(field_of_view(panel.camera()), narrowest_view, 1e-9);
}

// Undoing gives the view back that the number was changed in, whatever the scene's camera was.
TEST(CameraPanel, AViewThatHasMovedBecomesTheScenesFirst) {
    OpenCameraPanel panel;
    Camera moved;
    moved.eye = {1.0, 0.0, 0.0};
    panel.moved_view = moved;
    panel.redraws(2);
    panel.drag_by("roll", 23.0F);
    EXPECT_EQ(panel.camera().eye, moved.eye);
    EXPECT_NE(roll_of(panel.camera()), 0.0);
    panel.undo();
    EXPECT_EQ(panel.camera(), moved);
    EXPECT_EQ(panel.document.undo_name(), "Use of this view as the camera");
    panel.undo();
    EXPECT_EQ(panel.camera(), Camera{});
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(CameraPanel, WhatIsNoCameraIsRefused) {
    OpenCameraPanel panel;
    panel.enter("eye z", "100");
    EXPECT_EQ(panel.camera(), Camera{});
    EXPECT_NE(panel.text().find("'eye' and 'center' are the same point"), std::string::npos);
    panel.enter("field of view", "180");
    EXPECT_NE(panel.text().find("'180': a number from 0.001 to 179 is expected."), std::string::npos);
    EXPECT_FALSE(panel.has("refusal eye z"));
    EXPECT_EQ(panel.camera(), Camera{});
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(CameraPanel, TheProjectionIsAnEdit) {
    OpenCameraPanel panel;
    panel.click("projection");
    panel.redraws(3);
    panel.click("projection orthographic");
    EXPECT_TRUE(panel.camera().orthographic());
    EXPECT_EQ(panel.document.undo_name(), "Change the projection");
    EXPECT_TRUE(panel.has("slider side"));
    EXPECT_FALSE(panel.has("slider field of view"));
    const double side = screen_side(panel.camera());
    panel.drag_by("side", 103.0F);
    EXPECT_NEAR(screen_side(panel.camera()), side * std::exp(1.0), 0.01 * side);
    panel.undo();
    panel.undo();
    EXPECT_EQ(panel.camera(), Camera{});
}

TEST(CameraPanel, TheNativeFormatsOtherValuesAreShown) {
    Camera camera;
    camera.right = {0.0, 0.123456789, 0.0};
    camera.up = {0.123456789, 0.0, 0.0};
    OpenCameraPanel panel(camera);
    EXPECT_NE(panel.text().find("0, 0.1235, 0"), std::string::npos);
    EXPECT_NE(panel.text().find("0.1235, 0, 0"), std::string::npos);
}

}  // namespace sphereview

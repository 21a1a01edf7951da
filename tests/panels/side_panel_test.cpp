// The side panel as a whole: its parts, and what stays under the pointer.
#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

// Where there is no room below, the list makes some, and the part's heading moves: what comes under the pointer is not clicked.
TEST(SidePanel, ClicksOnAHeadingThatHasMovedAreStillMeantForIt) {
    SidePanelHarness panel(200, {});
    const ImVec2 heading = panel.place("camera");
    const auto is_open = [&] { return panel.has("save view"); };
    panel.click(heading);
    panel.redraws(6);
    ASSERT_TRUE(is_open());
    ASSERT_LT(panel.place("camera").y, heading.y - 30.0F);
    panel.take_actions();
    panel.click(heading);
    panel.redraws(6);
    EXPECT_FALSE(is_open());
    panel.click(heading);
    panel.redraws(6);
    EXPECT_TRUE(is_open());
    EXPECT_TRUE(panel.take_actions().empty());
    // The pointer was moved: now it is meant for what is there.
    panel.move({10.0F, 10.0F});
    panel.click(panel.place("camera"));
    panel.redraws(6);
    EXPECT_FALSE(is_open());
}

// The list is no higher than its rows, and half of the panel: what is below has room.
TEST(SidePanel, AHeadingStaysUnderThePointerWhereItsContentsHaveRoom) {
    for (const std::size_t spheres : {3U, 200U}) {
        for (const char* part : {"look", "light", "camera", "scene", "sphere"}) {
            SidePanelHarness panel(line_of_spheres(spheres), 1150.0F);
            const ImVec2 heading = panel.place(part);
            for (int click = 0; click < 4; ++click) {
                panel.click(heading);
                panel.redraws(6);
                EXPECT_EQ(panel.place(part).y, heading.y) << part << " of " << spheres << ", click " << click;
            }
            // Nor does the list jump once the pointer is elsewhere in the panel.
            panel.move(panel.place("filter"));
            panel.redraws(4);
            EXPECT_EQ(panel.place(part).y, heading.y) << part;
        }
    }
}

TEST(SidePanel, WhatIsBelowAnOpenedPartGoesDown) {
    SidePanelHarness panel(line_of_spheres(3), 900.0F);
    const float camera = panel.place("camera").y;
    panel.click("light");
    panel.redraws(6);
    EXPECT_GT(panel.place("camera").y, camera + 50.0F);
}

// The list gives way only as much as it has to, and gets its height back when nothing can be clicked by mistake.
TEST(SidePanel, TheListGrowsAgainWhenThePointerHasLeft) {
    SidePanelHarness panel(200, {});
    const float at_first = panel.place("camera").y;
    panel.click("camera");
    panel.redraws(6);
    const float opened = panel.place("camera").y;
    ASSERT_LT(opened, at_first - 30.0F);
    panel.move(panel.place("camera"));
    panel.click("camera");
    panel.redraws(6);
    ASSERT_FALSE(panel.has("save view"));
    EXPECT_EQ(panel.place("camera").y, opened);
    panel.move({1000.0F, 900.0F});
    panel.redraws(4);
    EXPECT_EQ(panel.place("camera").y, at_first);
}

// In a low panel the list cannot give way: what was opened is scrolled to, but its heading stays in view.
TEST(SidePanel, ALowPanelScrollsToWhatWasOpened) {
    for (const float height : {420.0F, 330.0F, 200.0F}) {
        SidePanelHarness panel(line_of_spheres(200), height);
        panel.move(panel.place("filter"));
        for (int i = 0; i < 20; ++i) panel.wheel(-5.0F);
        panel.redraws(3);
        panel.click("camera");
        panel.redraws(8);
        ASSERT_TRUE(panel.has("save view")) << height;
        const WidgetRectangle heading = panel.rectangles.at("camera");
        EXPECT_GE(heading.top, 0.0F) << height;
        // All of it, as far as there is room.
        EXPECT_TRUE(panel.rectangles.at("save view").bottom <= height || heading.top < 40.0F) << height;
        // Closed, it stays; the panel does not scroll under the pointer.
        panel.move(panel.place("camera"));
        panel.click("camera");
        panel.redraws(8);
        ASSERT_FALSE(panel.has("save view")) << height;
        EXPECT_NEAR(panel.rectangles.at("camera").top, heading.top, 1.0F) << height;
    }
}

TEST(SidePanel, AViewsDirectionsShowNoRounding) {
    OpenPartHarness panel(
        "camera",
        [](Scene& scene) {
            scene.camera.right = {50.0, 1.848e-16, 0.0};
        },
        1100.0F);
    panel.move({1000.0F, 900.0F});
    EXPECT_NE(panel.text().find("50, 0, 0"), std::string::npos) << panel.text();
}

}  // namespace sphereview

// The side panel as a whole: its parts, and what stays under the pointer.
#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

// The list makes room for a part that opens, and the part's heading moves: what comes under the pointer is not clicked.
TEST(SidePanel, ClicksOnAHeadingThatHasMovedAreStillMeantForIt) {
    for (const char* part : {"camera", "look"}) {
        SidePanelHarness panel(200, {});
        const ImVec2 heading = panel.place(part);
        const auto is_open = [&] { return panel.has(part == std::string("camera") ? "save view" : "colour by"); };
        panel.click(heading);
        panel.redraws(6);
        ASSERT_TRUE(is_open()) << part;
        ASSERT_LT(panel.place(part).y, heading.y - 30.0F) << part;
        panel.take_actions();
        panel.click(heading);
        panel.redraws(6);
        EXPECT_FALSE(is_open()) << part;
        panel.click(heading);
        panel.redraws(6);
        EXPECT_TRUE(is_open()) << part;
        EXPECT_TRUE(panel.take_actions().empty());
        // The pointer was moved: now it is meant for what is there.
        panel.move({10.0F, 10.0F});
        panel.click(panel.place(part));
        panel.redraws(6);
        EXPECT_FALSE(is_open()) << part;
    }
}

// Closed from where the heading is above, the list comes under the pointer.
TEST(SidePanel, AHeadingThatGoesDownLeavesNoClickForTheList) {
    SidePanelHarness panel(200, {});
    panel.click("camera");
    panel.redraws(6);
    const ImVec2 heading = panel.place("camera");
    panel.click(heading);
    panel.redraws(6);
    ASSERT_FALSE(panel.has("save view"));
    panel.take_actions();
    panel.click(heading);
    panel.redraws(6);
    EXPECT_TRUE(panel.has("save view"));
    EXPECT_TRUE(panel.taken<SelectSpheres>().empty());
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

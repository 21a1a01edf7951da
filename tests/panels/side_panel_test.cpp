#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

namespace {

TEST(ScenePanel, BackgroundIsChosen) {
    SidePanelHarness panel(line_of_spheres(2));
    const auto choose = [&](const std::string& name) {
        panel.click("background");
        panel.frames(2);
        panel.click("background " + name);
        return to_string(panel.document.scene().background);
    };
    EXPECT_EQ(choose("white"), "white");
    EXPECT_EQ(panel.document.undo_name(), "Change background");
    EXPECT_EQ(choose("transparent"), "transparent");
    EXPECT_FALSE(panel.has("background color"));
    EXPECT_EQ(choose("black"), "black");
    EXPECT_EQ(choose("colour"), "#808080");
    EXPECT_TRUE(panel.has("background color"));
    panel.take_actions();
    choose("colour");
    EXPECT_TRUE(panel.taken<EditScene>().empty());
}

TEST(ScenePanel, ButtonsRunCommands) {
    SidePanelHarness panel(line_of_spheres(2));
    panel.click("use view");
    panel.click("home");
    const auto commands = panel.taken<RunCommand>();
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(commands[0].command, CommandId::use_view_as_camera);
    EXPECT_EQ(commands[1].command, CommandId::go_home);
}

TEST(ScenePanel, TheFrameOfSeveralIsChosen) {
    SidePanelHarness panel(line_of_spheres(2));
    EXPECT_FALSE(panel.has("frame"));
    panel.frames_of_file = 11;
    panel.frame_of_file = 2;
    panel.frames(2);
    panel.take_actions();
    panel.click(panel.place("frame", 0.99F));
    auto shown = panel.taken<ShowFrame>();
    ASSERT_FALSE(shown.empty());
    EXPECT_EQ(shown.front().frame, 10);
    panel.click(panel.place("frame", 0.01F));
    shown = panel.taken<ShowFrame>();
    ASSERT_FALSE(shown.empty());
    EXPECT_EQ(shown.front().frame, 0);
}

TEST(ScenePanel, CameraIsShown) {
    Scene scene = line_of_spheres(2);
    scene.camera.eye = {0.123456789, 0.0, -7.0};
    SidePanelHarness panel(scene);
    EXPECT_EQ(panel.text().find("0.1235, 0, -7"), std::string::npos);
    panel.click("camera");
    EXPECT_NE(panel.text().find("0.1235, 0, -7"), std::string::npos);
}

TEST(ScenePanel, SmallPanelsScroll) {
    SidePanelHarness panel(line_of_spheres(50), 200.0F);
    panel.select({3});
    EXPECT_GE(panel.rows(), 4U);
    EXPECT_TRUE(panel.take_actions().empty());
}

}  // namespace

}  // namespace sphereview

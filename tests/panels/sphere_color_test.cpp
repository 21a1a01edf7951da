// The sphere editor's colour: its three numbers and the picker.
#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

namespace {

TEST(SphereColor, ColorIsEditedInWholeNumbers) {
    SidePanelHarness panel(5, {2});
    panel.enter("red", "200-50+51");
    EXPECT_EQ(panel.sphere(2).color, (Color{201, 20, 30}));
    EXPECT_EQ(panel.document.undo_name(), "Recolour sphere 2");
    panel.undo();
    EXPECT_EQ(panel.document.scene(), line_of_spheres(5)) << "typing is one step";
    for (const char* refused : {"256", "-1", "12.5"}) {
        panel.enter("green", refused);
        EXPECT_NE(panel.text().find(": a whole number from 0 to 255 is expected."), std::string::npos) << panel.text();
        panel.tap(ImGuiKey_Escape);
        panel.redraws(2);
    }
    panel.take_actions();
    panel.drag_by("red", 37.0F);
    panel.edits_of_one_gesture();
    panel.document.undo();
    EXPECT_EQ(panel.document.scene(), line_of_spheres(5));
}

TEST(SphereColor, EveryColorIsShownWithoutChange) {
    Scene scene = line_of_spheres(256);
    for (std::size_t i = 0; i < 256; ++i) {
        const auto part = static_cast<std::uint8_t>(i);
        scene.spheres[i].color = {part, static_cast<std::uint8_t>(255 - part), part};
    }
    SidePanelHarness panel(scene);
    for (std::uint32_t i = 0; i < 256; ++i) panel.select({i});
    EXPECT_TRUE(panel.take_actions().empty());
}

TEST(SphereColor, PickerIsOneGesture) {
    SidePanelHarness panel(5, {2});
    panel.click("color");  // the swatch opens it
    panel.redraws(3);
    panel.take_actions();
    const ImVec2 start = ImGui::GetIO().MousePos;
    // The picker opens where there is room: below the swatch.
    panel.drag({start.x + 10.0F, start.y + 100.0F}, {start.x + 30.0F, start.y + 140.0F});
    panel.edits_of_one_gesture();
    panel.document.undo();
    EXPECT_EQ(panel.document.scene(), line_of_spheres(5));
}

TEST(SphereColor, ADragOfAColorMovesAllByAsMuchAndLeavesTheOthers) {
    Scene scene = line_of_spheres(3);
    scene.spheres[0].color = {10, 20, 250};
    scene.spheres[1].color = {30, 40, 50};
    SidePanelHarness panel(scene);
    panel.select({0, 1});
    panel.redraws(3);  // the numbers go below each other, and the list gives them its room
    panel.drag_by("blue", 23.0F);
    const int by = panel.sphere(1).color.b - 50;
    EXPECT_GT(by, 5);
    EXPECT_EQ(panel.sphere(0).color, (Color{10, 20, 255}));
    EXPECT_EQ(panel.sphere(1).color.r, 30);
    EXPECT_EQ(panel.sphere(1).color.g, 40);
    EXPECT_EQ(panel.sphere(2), scene.spheres[2]);
}

TEST(SphereColor, ChannelsStandBelowEachOtherWhereALineHasNoRoomForThem) {
    Scene scene = line_of_spheres(3);
    for (std::size_t i = 0; i < 3; ++i) scene.spheres[i].color = {static_cast<std::uint8_t>(100 + 50 * i), 144, 144};
    const auto lines = [&](float width, const std::vector<std::uint32_t>& selected) {
        SidePanelState state;
        PanelHarness panel(
            PanelHarness::in_window([&](const PanelContext& context) { draw_sphere_editor(context, state); }, width, 700.0F), scene,
            1400.0F, 1200.0F);
        panel.selection.set(selected);
        panel.redraws(3);
        EXPECT_NE(panel.text().find("144"), std::string::npos) << panel.text();
        EXPECT_GE(panel.rectangles.at("slider red").right - panel.rectangles.at("slider red").left, ImGui::GetFontSize());
        const auto top = [&](const char* name) { return panel.rectangles.at(name).top; };
        EXPECT_EQ(top("color"), top("slider blue"));
        return top("slider red") == top("slider blue") ? 1 : 3;
    };
    EXPECT_EQ(lines(340.0F, {1}), 1);
    EXPECT_EQ(lines(200.0F, {1}), 3);
    EXPECT_EQ(lines(340.0F, {0, 1, 2}), 3) << "\"100 to 200\" is longer";
}

}  // namespace

}  // namespace sphereview

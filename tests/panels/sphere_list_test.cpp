#include <gtest/gtest.h>

#include "panels/harness.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(SphereList, ClicksSelectOneTogglesOrSelectARange) {
    SidePanelHarness panel(line_of_spheres(6));
    panel.click("row 1");
    panel.modifiers(true);
    panel.click("row 3");
    panel.expect_selected({1, 3});
    EXPECT_EQ(panel.selection.primary(), 3U);
    panel.click("row 1");
    panel.expect_selected({3});
    panel.modifiers(false, true);
    panel.click("row 4");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 2, 3, 4})) << "from the row clicked last";
    EXPECT_EQ(panel.selection.primary(), 4U);
    panel.click("row 0");
    panel.expect_selected({0, 1});
    EXPECT_EQ(panel.selection.primary(), 0U);
    panel.modifiers(true, true);
    panel.modifiers(true, false);
    panel.click("row 5");
    panel.modifiers(true, true);
    panel.click("row 3");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{0, 1, 3, 4, 5})) << "a range joins";
    panel.modifiers(false);
    panel.click("row 3");
    panel.expect_selected({3});
    const ImVec2 last = panel.place("row 5", 0.5F, 1.0F);
    panel.click(ImVec2{last.x, last.y + 20.0F});
    EXPECT_TRUE(panel.selection.empty()) << "beside the rows";
}

TEST(SphereList, HoveredRowIsTheHoveredSphere) {
    SidePanelHarness panel(line_of_spheres(3));
    panel.move(panel.place("row 2"));
    EXPECT_EQ(panel.hovered, 2U);
    panel.move(panel.place("row 0 eye"));
    EXPECT_EQ(panel.hovered, 0U);
    panel.move(panel.place("filter"));
    EXPECT_EQ(panel.hovered, std::nullopt);
}

TEST(SphereList, EyeHidesAndShows) {
    Scene scene = line_of_spheres(3);
    scene.names[1] = "sun";
    SidePanelHarness panel(scene);
    panel.click("row 1 eye");
    EXPECT_TRUE(panel.sphere(1).hidden);
    EXPECT_TRUE(panel.selection.empty());
    EXPECT_EQ(panel.document.undo_name(), "Hide sphere 1 'sun'");
    panel.click("row 1 eye");
    EXPECT_EQ(panel.document.scene(), scene);
    EXPECT_EQ(panel.document.undo_name(), "Show sphere 1 'sun'");
}

TEST(SphereList, FilterNarrowsWhileTyping) {
    Scene scene = line_of_spheres(300);
    scene.names[7] = "Red Giant";
    scene.names[250] = "gIANt";
    SidePanelHarness panel(scene);
    panel.type_into("filter", "gia");
    EXPECT_TRUE(panel.has("row 7"));
    EXPECT_TRUE(panel.has("row 250"));
    EXPECT_EQ(panel.rows(), 2U);
    panel.type("x");
    EXPECT_EQ(panel.rows(), 0U);
    panel.click("clear filter");
    EXPECT_TRUE(panel.has("row 0"));
    EXPECT_TRUE(panel.has("row 1"));
    panel.type_into("filter", "29");
    EXPECT_TRUE(panel.has("row 29"));
    EXPECT_TRUE(panel.has("row 290"));
    EXPECT_FALSE(panel.has("row 2"));
    panel.click("row 29");
    panel.modifiers(false, true);
    panel.click("row 291");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{29, 290, 291})) << "a range has only what the filter shows";
}

TEST(SphereList, DoubleClickRenamesInPlace) {
    SidePanelHarness panel(line_of_spheres(3));
    panel.double_click("row 1");
    panel.redraws(2);
    ASSERT_TRUE(panel.has("rename"));
    panel.type("mars");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.document.scene().names.at(1), "mars");
    EXPECT_FALSE(panel.has("rename"));
    EXPECT_EQ(panel.document.undo_name(), "Rename sphere 1");
}

TEST(SphereList, EscapeKeepsTheOldName) {
    Scene scene = line_of_spheres(3);
    scene.names[2] = "sun";
    SidePanelHarness panel(scene);
    panel.begin_renaming(2, "moon");
    panel.tap(ImGuiKey_Escape);
    EXPECT_FALSE(panel.has("rename"));
    EXPECT_EQ(panel.document.scene(), scene);
    EXPECT_FALSE(panel.document.can_undo());
    panel.begin_renaming(2, "moon");
    panel.click("row 0");
    EXPECT_EQ(panel.document.scene().names.at(2), "moon") << "a click elsewhere accepts the name";
    panel.expect_selected({0});
}

TEST(SphereList, RenamingScrollsToTheRowAndDropsAFilterThatHidesIt) {
    SidePanelHarness panel(line_of_spheres(1000));
    panel.type_into("filter", "3");
    panel.begin_renaming(800, "far");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.document.scene().names.at(800), "far");
}

TEST(SphereList, NameIsKeptWhenItsRowScrollsAway) {
    SidePanelHarness panel(line_of_spheres(1000));
    panel.begin_renaming(0, "first");
    panel.move(panel.place("row 3"));
    for (int i = 0; i < 20; ++i) panel.wheel(-5.0F);
    EXPECT_FALSE(panel.has("row 0"));
    EXPECT_EQ(panel.document.scene().names.at(0), "first");
}

TEST(SphereList, RenamingEndsWhenNumbersChangeTheirMeaning) {
    SidePanelHarness panel(line_of_spheres(4));
    panel.begin_renaming(2, "moon");
    panel.document.apply(RemoveSpheres{{0}}, "");
    panel.redraws(3);
    EXPECT_FALSE(panel.has("rename"));
    EXPECT_TRUE(panel.document.scene().names.empty());
}

TEST(SphereList, DraggedRowGetsAnotherPlace) {
    SidePanelHarness panel(line_of_spheres(6));
    const Scene before = panel.document.scene();
    panel.drag(panel.place("row 1"), panel.place("row 4", 0.5F, 0.1F));  // between 3 and 4
    EXPECT_EQ(panel.sphere(3), before.spheres[1]);
    EXPECT_EQ(panel.sphere(1), before.spheres[2]);
    EXPECT_EQ(panel.document.undo_name(), "Reorder sphere 1");
    panel.undo();
    panel.drag(panel.place("row 4"), panel.place("row 0", 0.5F, 0.1F));
    EXPECT_EQ(panel.sphere(0), before.spheres[4]);
    panel.undo();
    panel.drag(panel.place("row 2"), panel.place("row 5", 0.5F, 0.9F));
    EXPECT_EQ(panel.sphere(5), before.spheres[2]);
}

TEST(SphereList, DragThatEndsWhereItBeganOrIsCancelledChangesNothing) {
    SidePanelHarness panel(line_of_spheres(6));
    panel.drag(panel.place("row 1"), panel.place("row 1", 0.9F, 0.9F));
    panel.move(panel.place("row 1"));
    panel.press();
    panel.move(panel.place("row 4"));
    panel.tap(ImGuiKey_Escape);
    panel.move(panel.place("row 5"));
    panel.release();
    panel.redraws(2);
    EXPECT_TRUE(panel.taken<EditScene>().empty());
}

TEST(SphereList, ArrowKeysGoThroughTheList) {
    SidePanelHarness panel(line_of_spheres(500));
    panel.click("row 1");
    panel.tap(ImGuiKey_DownArrow);
    panel.expect_selected({2});
    panel.tap(ImGuiKey_UpArrow);
    panel.tap(ImGuiKey_UpArrow);
    panel.tap(ImGuiKey_UpArrow);
    panel.expect_selected({0});
    for (int i = 0; i < 60; ++i) panel.tap(ImGuiKey_DownArrow);
    panel.redraws(2);
    panel.expect_selected({60});
    EXPECT_TRUE(panel.has("row 60")) << "the list follows";
}

TEST(SphereList, RightClickOffersCommandsForTheRow) {
    SidePanelHarness panel(line_of_spheres(4));
    panel.click("row 2", 1);
    panel.expect_selected({2});
    panel.take_actions();
    panel.click("row menu Delete");
    EXPECT_EQ(panel.commands_taken(), std::vector{CommandId::remove});
    panel.click("row 1", 1);
    panel.click("row menu Rename");
    panel.redraws(3);
    EXPECT_TRUE(panel.has("rename"));
    EXPECT_EQ(panel.state().renaming.of, 1U);
    panel.select({1, 2});
    panel.click("row 2", 1);
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 2})) << "a selected row keeps the selection";
}

TEST(SphereList, ButtonsRunCommandsThatAreEnabled) {
    SidePanelHarness panel(line_of_spheres(4));
    for (CommandInfo& info : panel.commands) info.enabled = info.id != CommandId::remove;
    panel.redraws();
    panel.click("delete");
    EXPECT_TRUE(panel.take_actions().empty());
    for (const auto& [widget, id] : {std::pair("add", CommandId::add_sphere), std::pair("duplicate", CommandId::duplicate),
                                     std::pair("hide", CommandId::hide)}) {
        panel.click(widget);
        EXPECT_EQ(panel.commands_taken(), std::vector{id}) << widget;
    }
}

TEST(SphereList, EmptySceneSaysSo) {
    SidePanelHarness panel(Scene{});
    EXPECT_NE(panel.text().find("no spheres"), std::string::npos);
    EXPECT_EQ(panel.rows(), 0U);
}

TEST(ScenePanel, BackgroundIsChosen) {
    SidePanelHarness panel(line_of_spheres(2));
    const auto choose = [&](const std::string& name) {
        panel.click("background");
        panel.redraws(2);
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

TEST(ScenePanel, SmallPanelsScroll) {
    SidePanelHarness panel(line_of_spheres(50), 200.0F);
    panel.select({3});
    EXPECT_GE(panel.rows(), 4U);
    EXPECT_TRUE(panel.take_actions().empty());
}

}  // namespace

}  // namespace sphereview

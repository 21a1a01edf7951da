#include <cmath>

#include "panels/side_panel_harness.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

TEST(SphereList, ClickSelectsOneSphere) {
    SidePanelHarness panel(line_of_spheres(5));
    panel.click("row 3");
    EXPECT_EQ(panel.selection.numbers(), Numbers{3});
    panel.click("row 1");
    EXPECT_EQ(panel.selection.numbers(), Numbers{1});
}

TEST(SphereList, CtrlClickTogglesAndShiftClickSelectsARange) {
    SidePanelHarness panel(line_of_spheres(6));
    panel.click("row 1");
    panel.modifiers(true);
    panel.click("row 3");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 3}));
    EXPECT_EQ(panel.selection.primary(), 3U);
    panel.click("row 1");
    EXPECT_EQ(panel.selection.numbers(), Numbers{3});
    panel.modifiers(false, true);
    panel.click("row 4");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 2, 3, 4})) << "from the row clicked last";
    EXPECT_EQ(panel.selection.primary(), 4U);
    panel.click("row 0");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{0, 1}));
    EXPECT_EQ(panel.selection.primary(), 0U);
    panel.modifiers(true, true);
    panel.modifiers(true, false);
    panel.click("row 5");
    panel.modifiers(true, true);
    panel.click("row 3");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{0, 1, 3, 4, 5})) << "a range joins";
}

TEST(SphereList, ClickBesideTheRowsSelectsNone) {
    SidePanelHarness panel(line_of_spheres(2));
    panel.click("row 1");
    const ImVec2 last = panel.place("row 1", 0.5F, 1.0F);
    panel.click(ImVec2{last.x, last.y + 20.0F});
    EXPECT_TRUE(panel.selection.empty());
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
    EXPECT_EQ(panel.document.undo_name(), "Hide 'sun'");
    panel.click("row 1 eye");
    EXPECT_EQ(panel.document.scene(), scene);
    EXPECT_EQ(panel.document.undo_name(), "Show 'sun'");
}

TEST(SphereList, FilterNarrowsWhileTyping) {
    Scene scene = line_of_spheres(300);
    scene.names[7] = "Red Giant";
    scene.names[250] = "gIANt";
    SidePanelHarness panel(scene);
    panel.click("filter");
    panel.type("gia");
    EXPECT_TRUE(panel.has("row 7"));
    EXPECT_TRUE(panel.has("row 250"));
    EXPECT_EQ(panel.rows(), 2U);
    panel.type("x");
    EXPECT_EQ(panel.rows(), 0U);
    panel.click("clear filter");
    EXPECT_TRUE(panel.has("row 0"));
    EXPECT_TRUE(panel.has("row 1"));
    panel.click("filter");
    panel.type("29");
    EXPECT_TRUE(panel.has("row 29"));
    EXPECT_TRUE(panel.has("row 290"));
    EXPECT_FALSE(panel.has("row 2"));
}

TEST(SphereList, FilterFollowsTheScene) {
    Scene scene = line_of_spheres(4);
    scene.names[2] = "moon";
    SidePanelHarness panel(scene);
    panel.click("filter");
    panel.type("moo");
    EXPECT_EQ(panel.rows(), 1U);
    panel.document.apply(RenameSphere{3, "mood"}, "");
    panel.frames();
    EXPECT_TRUE(panel.has("row 3"));
    panel.document.apply(RemoveSpheres{{0, 1, 2}}, "");
    panel.frames();
    EXPECT_TRUE(panel.has("row 0"));
    EXPECT_EQ(panel.rows(), 1U);
}

TEST(SphereList, ShiftClickInAFilteredListTakesOnlyWhatItShows) {
    SidePanelHarness panel(line_of_spheres(30));
    panel.click("filter");
    panel.type("1");
    panel.click("row 1");
    panel.modifiers(false, true);
    panel.click("row 12");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 10, 11, 12}));
}

TEST(SphereList, DoubleClickRenamesInPlace) {
    SidePanelHarness panel(line_of_spheres(3));
    panel.double_click("row 1");
    panel.frames(2);
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
    start_renaming(panel.state(), panel.document.scene(), 2);
    panel.frames(3);
    panel.type("moon");
    panel.tap(ImGuiKey_Escape);
    EXPECT_FALSE(panel.has("rename"));
    EXPECT_EQ(panel.document.scene(), scene);
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(SphereList, ClickElsewhereAcceptsTheName) {
    SidePanelHarness panel(line_of_spheres(3));
    start_renaming(panel.state(), panel.document.scene(), 2);
    panel.frames(3);
    panel.type("moon");
    panel.click("row 0");
    EXPECT_EQ(panel.document.scene().names.at(2), "moon");
    EXPECT_EQ(panel.selection.numbers(), Numbers{0});
}

TEST(SphereList, RenamingScrollsToTheRowAndDropsAFilterThatHidesIt) {
    SidePanelHarness panel(line_of_spheres(1000));
    panel.click("filter");
    panel.type("3");
    start_renaming(panel.state(), panel.document.scene(), 800);
    panel.frames(4);
    ASSERT_TRUE(panel.has("rename"));
    panel.type("far");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.document.scene().names.at(800), "far");
}

TEST(SphereList, NameIsKeptWhenItsRowScrollsAway) {
    SidePanelHarness panel(line_of_spheres(1000));
    start_renaming(panel.state(), panel.document.scene(), 0);
    panel.frames(3);
    panel.type("first");
    panel.move(panel.place("row 3"));
    for (int i = 0; i < 20; ++i) panel.wheel(-5.0F);
    EXPECT_FALSE(panel.has("row 0"));
    EXPECT_EQ(panel.document.scene().names.at(0), "first");
}

TEST(SphereList, RenamingEndsWhenNumbersChangeTheirMeaning) {
    SidePanelHarness panel(line_of_spheres(4));
    start_renaming(panel.state(), panel.document.scene(), 2);
    panel.frames(3);
    panel.type("moon");
    panel.document.apply(RemoveSpheres{{0}}, "");
    panel.frames(3);
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
    panel.document.undo();
    panel.frames();
    panel.drag(panel.place("row 4"), panel.place("row 0", 0.5F, 0.1F));
    EXPECT_EQ(panel.sphere(0), before.spheres[4]);
    panel.document.undo();
    panel.frames();
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
    panel.frames(2);
    EXPECT_TRUE(panel.taken<EditScene>().empty());
}

TEST(SphereList, OfManySpheresOnlyVisibleRowsAreDrawn) {
    SidePanelHarness panel(line_of_spheres(1000));
    EXPECT_TRUE(panel.has("row 0"));
    EXPECT_GE(panel.rows(), 5U);
    EXPECT_LE(panel.rows(), 40U);
    EXPECT_FALSE(panel.has("row 999"));
    panel.selection.set_only(999);
    panel.state().scroll_to_selection = true;
    panel.frames(3);
    EXPECT_TRUE(panel.has("row 999"));
    EXPECT_FALSE(panel.has("row 0"));
    panel.click("row 999");
    EXPECT_EQ(panel.selection.numbers(), Numbers{999});
}

TEST(SphereList, AMillionSpheresTakeNoMoreWorkThanTheVisibleRows) {
    SidePanelHarness panel(line_of_spheres(1'000'000));
    const int vertices = panel.vertices();
    EXPECT_LE(panel.rows(), 40U);
    EXPECT_TRUE(panel.state().search.found().empty()) << "nothing is written down for each sphere";
    for (const std::uint32_t number : {999'999U, 654'321U, 500'000U}) {
        panel.selection.set_only(number);
        panel.state().scroll_to_selection = true;
        panel.frames(3);
        ASSERT_TRUE(panel.has("row " + std::to_string(number)));
        EXPECT_LE(panel.rows(), 40U);
        EXPECT_LE(panel.vertices(), 2 * vertices);
        // Far down, too, rows stand evenly, and a click finds the one under it.
        const std::string above = "row " + std::to_string(number - 1);
        EXPECT_EQ(panel.place(above, 0.0F, 1.0F).y, panel.place("row " + std::to_string(number), 0.0F, 0.0F).y);
        panel.click(above);
        EXPECT_EQ(panel.selection.numbers(), Numbers{number - 1});
    }
}

TEST(SphereList, EveryRowOfAMillionIsReached) {
    SidePanelHarness panel(line_of_spheres(1'000'000));
    panel.click("row 2");
    panel.tap(ImGuiKey_End);
    panel.frames(2);
    EXPECT_EQ(panel.selection.numbers(), Numbers{999'999});
    EXPECT_TRUE(panel.has("row 999999"));
    panel.tap(ImGuiKey_UpArrow);
    EXPECT_EQ(panel.selection.numbers(), Numbers{999'998});
    panel.tap(ImGuiKey_Home);
    panel.frames(2);
    EXPECT_EQ(panel.selection.numbers(), Numbers{0});
    EXPECT_TRUE(panel.has("row 0"));
    // By the scroll bar to the very end, and back by the wheel a little.
    const ImVec2 top = panel.place("list scroll bar", 0.5F, 0.001F);
    panel.drag(top, {top.x, top.y + 2000.0F}, 3);
    ASSERT_TRUE(panel.has("row 999999"));
    const float height = panel.place("row 999998", 0.0F, 1.0F).y - panel.place("row 999998", 0.0F, 0.0F).y;
    EXPECT_EQ(height, std::round(height)) << "whole pixels, so far down, too";
    EXPECT_EQ(panel.place("row 999998", 0.0F, 1.0F).y, panel.place("row 999999", 0.0F, 0.0F).y);
    panel.click("row 999999");
    EXPECT_EQ(panel.selection.numbers(), Numbers{999'999});
    panel.wheel(1.0F);
    panel.frames();
    EXPECT_FALSE(panel.has("row 999999")) << "out of sight after three rows";
    EXPECT_TRUE(panel.has("row 999996"));
    panel.move(panel.place("row 999995"));
    for (int i = 0; i < 100; ++i) panel.wheel(1.0F);
    panel.frames();
    EXPECT_FALSE(panel.has("row 999996"));
    EXPECT_TRUE(panel.has("row 999690"));
}

TEST(SphereList, PageKeysAndShiftSelectRanges) {
    SidePanelHarness panel(line_of_spheres(500));
    panel.click("row 3");
    panel.tap(ImGuiKey_PageDown);
    const std::uint32_t page = panel.selection.numbers().front() - 3;
    EXPECT_GT(page, 3U);
    EXPECT_LT(page, 40U);
    panel.tap(ImGuiKey_PageDown);
    EXPECT_EQ(panel.selection.numbers(), Numbers{3 + 2 * page});
    panel.tap(ImGuiKey_PageUp);
    EXPECT_EQ(panel.selection.numbers(), Numbers{3 + page});
    panel.modifiers(false, true);
    panel.tap(ImGuiKey_End);
    EXPECT_EQ(panel.selection.size(), 500 - (3 + page));
    panel.tap(ImGuiKey_Home);
    EXPECT_EQ(panel.selection.size(), 3 + page + 1) << "from the row clicked or gone to last";
}

TEST(SphereList, WhatTheFilterShowsIsSelected) {
    SidePanelHarness panel(line_of_spheres(120));
    panel.selection.set({3, 7});
    panel.click("filter");
    panel.type("11");
    panel.modifiers(true);
    panel.click("select filtered");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{3, 7, 11, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119}));
    panel.modifiers(false);
    panel.click("select filtered");
    EXPECT_EQ(panel.selection.numbers(), (Numbers{11, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119}));
}

TEST(SphereList, AFilterOfManyNamesAnswersBeforeItIsDone) {
    Scene scene = line_of_spheres(300'000);
    for (std::uint32_t i = 0; i < 300'000; ++i) {
        scene.names.emplace_hint(scene.names.end(), i, (i % 100'000 == 7 ? "Planet " : "dust ") + std::to_string(i));
    }
    SidePanelHarness panel(scene);
    panel.click("filter");
    panel.type("PLAN");
    EXPECT_TRUE(panel.has("row 7")) << "what was found so far";
    EXPECT_FALSE(panel.state().search.done());
    EXPECT_NE(panel.text().find("% looked at"), std::string::npos);
    // A move of a sphere begins nothing anew; a name does.
    const double part = panel.state().search.part();
    panel.document.apply(ChangeSpheres{{5}, {scene.spheres[6]}}, "");
    panel.frames();
    EXPECT_GT(panel.state().search.part(), part);
    panel.document.apply(RenameSphere{8, "Planet X"}, "");
    panel.frames();
    EXPECT_LE(panel.state().search.part(), part);
    panel.frames(10);
    EXPECT_TRUE(panel.state().search.done());
    EXPECT_EQ(panel.state().search.found(), (Numbers{7, 8, 100'007, 200'007}));
    panel.click("select filtered");
    EXPECT_EQ(panel.selection.size(), 4U);
    panel.document.undo();
    panel.frames(12);
    EXPECT_EQ(panel.state().search.found().size(), 3U) << "undoing a name is followed, too";
    EXPECT_EQ(panel.rows(), 3U);
}

TEST(SphereList, ArrowKeysGoThroughTheList) {
    SidePanelHarness panel(line_of_spheres(500));
    panel.click("row 1");
    panel.tap(ImGuiKey_DownArrow);
    EXPECT_EQ(panel.selection.numbers(), Numbers{2});
    panel.tap(ImGuiKey_UpArrow);
    panel.tap(ImGuiKey_UpArrow);
    panel.tap(ImGuiKey_UpArrow);
    EXPECT_EQ(panel.selection.numbers(), Numbers{0});
    for (int i = 0; i < 60; ++i) panel.tap(ImGuiKey_DownArrow);
    panel.frames(2);
    EXPECT_EQ(panel.selection.numbers(), Numbers{60});
    EXPECT_TRUE(panel.has("row 60")) << "the list follows";
}

TEST(SphereList, RightClickOffersCommandsForTheRow) {
    SidePanelHarness panel(line_of_spheres(4));
    panel.click("row 2", 1);
    EXPECT_EQ(panel.selection.numbers(), Numbers{2});
    panel.take_actions();
    panel.click("row menu Delete");
    const auto commands = panel.taken<RunCommand>();
    ASSERT_EQ(commands.size(), 1U);
    EXPECT_EQ(commands[0].command, CommandId::remove);
    panel.click("row 1", 1);
    panel.click("row menu Rename");
    panel.frames(3);
    EXPECT_TRUE(panel.has("rename"));
    EXPECT_EQ(panel.state().renaming, 1U);
}

TEST(SphereList, RightClickOnASelectedRowKeepsTheSelection) {
    SidePanelHarness panel(line_of_spheres(4));
    panel.selection.set({1, 2});
    panel.click("row 2", 1);
    EXPECT_EQ(panel.selection.numbers(), (Numbers{1, 2}));
}

TEST(SphereList, ButtonsRunCommandsThatAreEnabled) {
    SidePanelHarness panel(line_of_spheres(4));
    panel.enabled = [](CommandId id) { return id != CommandId::remove; };
    panel.frames();
    panel.click("delete");
    EXPECT_TRUE(panel.take_actions().empty());
    for (const auto& [widget, id] : {std::pair("add", CommandId::add_sphere), std::pair("duplicate", CommandId::duplicate),
                                     std::pair("hide", CommandId::hide)}) {
        panel.click(widget);
        const auto commands = panel.taken<RunCommand>();
        ASSERT_EQ(commands.size(), 1U) << widget;
        EXPECT_EQ(commands[0].command, id);
    }
}

TEST(SphereList, EmptySceneSaysSo) {
    SidePanelHarness panel(Scene{});
    EXPECT_NE(panel.text().find("no spheres"), std::string::npos);
    EXPECT_EQ(panel.rows(), 0U);
}

}  // namespace

}  // namespace sphereview

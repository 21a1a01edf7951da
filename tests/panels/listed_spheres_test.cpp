#include <gtest/gtest.h>

#include <cmath>

#include "panels/harness.hpp"
#include "panels/listed_spheres.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

using Numbers = std::vector<std::uint32_t>;

Scene some() {
    Scene scene = scene_of_alike(125);
    scene.names = {{0, "Sun"}, {12, "sunflower 3"}, {99, "Ümlaut"}};
    return scene;
}

Numbers filtered(const Scene& scene, const std::string& filter) {
    FilterSearch search;
    search.begin(scene, filter);
    search.finish(scene);
    // However small the steps are, the same is found.
    FilterSearch slow;
    slow.begin(scene, filter);
    for (int i = 0; !slow.done(); ++i) {
        slow.go_on(scene, 1);
        EXPECT_LE(i, 3000);
    }
    EXPECT_EQ(slow.found(), search.found()) << filter;
    return search.found();
}

TEST(SphereFilter, FindsNamesWhateverTheCase) {
    EXPECT_EQ(filtered(some(), "SUN"), (Numbers{0, 12}));
    EXPECT_EQ(filtered(some(), " sunf "), Numbers{12});
    EXPECT_EQ(filtered(some(), "Üml"), Numbers{99});
    EXPECT_TRUE(filtered(some(), "moon").empty());
}

TEST(SphereFilter, FindsNumbersByTheirFirstDigits) {
    EXPECT_EQ(filtered(some(), "12"), (Numbers{12, 120, 121, 122, 123, 124}));
    EXPECT_EQ(filtered(some(), "sphere 124"), Numbers{124});
    EXPECT_EQ(filtered(some(), "#7"), (Numbers{7, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79}));
    EXPECT_EQ(filtered(some(), "99999999999999999999999"), Numbers{});
    EXPECT_EQ(filtered(some(), "3").front(), 3U);
    EXPECT_EQ(filtered(some(), "3")[1], 12U) << "by its name";
}

TEST(SphereFilter, NumbersAreThoseWhoseTextBeginsSo) {
    Scene scene = scene_of_alike(2345);
    for (const std::string digits : {"0", "1", "2", "9", "10", "23", "234", "2344", "2345", "01", "00"}) {
        Numbers expected;
        for (std::uint32_t number = 0; number < 2345; ++number) {
            if (std::to_string(number).starts_with(digits)) expected.push_back(number);
        }
        EXPECT_EQ(filtered(scene, digits), expected) << digits;
    }
}

TEST(SphereFilter, TitleOfSpheresWithoutANameIsFound) {
    EXPECT_EQ(filtered(some(), "sphere").size(), 122U);
    EXPECT_EQ(filtered(some(), "sph").size(), 122U);
}

Scene charged() {
    Scene scene = some();
    std::vector<double> charges;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) charges.push_back(0.01 * static_cast<double>(i));
    scene.properties = {{"charge", std::move(charges)}};
    return scene;
}

TEST(SphereFilter, FindsWhatFulfilsACondition) {
    EXPECT_EQ(filtered(charged(), "charge > 1.215"), (Numbers{122, 123, 124}));
    EXPECT_EQ(filtered(charged(), " number < 2 or charge = 0.5"), (Numbers{0, 1, 50}));
    FilterSearch search;
    search.begin(charged(), "charge > and");
    EXPECT_TRUE(search.done());
    EXPECT_EQ(search.fault(), "column 10: found 'and', expected a number");
    search.begin(charged(), "mass > 1 and Charge > 1");
    EXPECT_EQ(search.unknown(), std::vector<std::string>{"mass"});
    EXPECT_EQ(search.fault(), "column 1: found 'mass', expected the name of a property: charge, x, y, z, radius, number or name");
    EXPECT_EQ(search.compared(), (std::vector<std::string>{"mass", "Charge"}));
}

TEST(ListedSpheres, RowsAndNumbersBelongTogether) {
    const Scene scene = some();
    const Numbers listed{3, 7, 50};
    const ListedSpheres some_listed(scene, false, listed);
    EXPECT_EQ(some_listed.size(), 3U);
    EXPECT_EQ(some_listed.row_of(7), 1U);
    EXPECT_EQ(some_listed.row_of(8), std::nullopt);
    EXPECT_EQ(some_listed.between(2, 1), (Numbers{7, 50}));
    const ListedSpheres all(scene, true, listed);
    EXPECT_EQ(all.size(), 125U);
    EXPECT_EQ(all[124], 124U);
    EXPECT_EQ(all.row_of(125), std::nullopt);
}

TEST(SphereList, AMillionSpheresTakeNoMoreWorkThanTheVisibleRows) {
    SidePanelHarness panel(line_of_spheres(1'000'000));
    const int vertices = panel.vertices();
    EXPECT_TRUE(panel.has("row 0"));
    EXPECT_LE(panel.rows(), 40U);
    EXPECT_TRUE(panel.state().search.found().empty()) << "nothing is written down for each sphere";
    for (const std::uint32_t number : {999'999U, 654'321U, 500'000U}) {
        panel.selection.set_only(number);
        panel.state().scroll_to_selection = true;
        panel.redraws(3);
        ASSERT_TRUE(panel.has("row " + std::to_string(number)));
        EXPECT_LE(panel.rows(), 40U);
        EXPECT_LE(panel.vertices(), 2 * vertices);
        // Far down, too, rows stand evenly, and a click finds the one under it.
        const std::string above = "row " + std::to_string(number - 1);
        EXPECT_EQ(panel.place(above, 0.0F, 1.0F).y, panel.place("row " + std::to_string(number), 0.0F, 0.0F).y);
        panel.click(above);
        panel.expect_selected({number - 1});
    }
}

TEST(SphereList, EveryRowOfAMillionIsReached) {
    SidePanelHarness panel(line_of_spheres(1'000'000));
    panel.click("row 2");
    panel.tap(ImGuiKey_End);
    panel.redraws(2);
    panel.expect_selected({999'999});
    EXPECT_TRUE(panel.has("row 999999"));
    panel.tap(ImGuiKey_UpArrow);
    panel.expect_selected({999'998});
    panel.tap(ImGuiKey_Home);
    panel.redraws(2);
    panel.expect_selected({0});
    EXPECT_TRUE(panel.has("row 0"));
    // By the scroll bar to the very end, and back by the wheel a little.
    const ImVec2 top = panel.place("list scroll bar", 0.5F, 0.001F);
    panel.drag(top, {top.x, top.y + 2000.0F}, 3);
    ASSERT_TRUE(panel.has("row 999999"));
    const float height = panel.place("row 999998", 0.0F, 1.0F).y - panel.place("row 999998", 0.0F, 0.0F).y;
    EXPECT_EQ(height, std::round(height)) << "whole pixels, so far down, too";
    EXPECT_EQ(panel.place("row 999998", 0.0F, 1.0F).y, panel.place("row 999999", 0.0F, 0.0F).y);
    panel.click("row 999999");
    panel.expect_selected({999'999});
    panel.wheel(1.0F);
    panel.redraws();
    EXPECT_FALSE(panel.has("row 999999")) << "out of sight after three rows";
    EXPECT_TRUE(panel.has("row 999996"));
    panel.move(panel.place("row 999995"));
    for (int i = 0; i < 100; ++i) panel.wheel(1.0F);
    panel.redraws();
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
    panel.expect_selected({3 + 2 * page});
    panel.tap(ImGuiKey_PageUp);
    panel.expect_selected({3 + page});
    panel.modifiers(false, true);
    panel.tap(ImGuiKey_End);
    EXPECT_EQ(panel.selection.size(), 500 - (3 + page));
    panel.tap(ImGuiKey_Home);
    EXPECT_EQ(panel.selection.size(), 3 + page + 1) << "from the row clicked or gone to last";
}

TEST(SphereList, WhatTheFilterShowsIsSelected) {
    SidePanelHarness panel(line_of_spheres(120));
    panel.selection.set({3, 7});
    panel.type_into("filter", "11");
    panel.modifiers(true);
    panel.click("select filtered");
    panel.expect_selected({3, 7, 11, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119});
    panel.modifiers(false);
    panel.click("select filtered");
    panel.expect_selected({11, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119});
}

TEST(SphereList, WhatFulfilsAConditionIsSelectedAndHidden) {
    SidePanelHarness panel(charged());
    panel.type_into("filter", "charge >= 1.22");
    EXPECT_EQ(panel.rows(), 3U);
    panel.click("select filtered");
    panel.expect_selected({122, 123, 124});
    panel.click("hide filtered");
    EXPECT_FALSE(panel.sphere(121).hidden);
    for (const std::uint32_t number : {122U, 123U, 124U}) EXPECT_TRUE(panel.sphere(number).hidden);
    EXPECT_EQ(panel.document.undo_name(), "Hide 3 spheres");
    panel.click("hide filtered");
    EXPECT_FALSE(panel.sphere(123).hidden);
    EXPECT_FALSE(panel.has("filter fault"));
    // What a condition asks for may change with every edit.
    panel.click("clear filter");
    panel.type_into("filter", "radius > 500");
    EXPECT_EQ(panel.rows(), 0U);
    panel.document.apply(ChangeSpheres{{5}, {{{}, 1000.0}}}, "");
    panel.redraws(2);
    EXPECT_EQ(panel.state().search.found(), Numbers{5});
    panel.document.apply(RemoveSpheres{{0, 1}}, "");
    panel.redraws(2);
    EXPECT_EQ(panel.state().search.found(), Numbers{3});
}

TEST(SphereList, AConditionSaysWhatIsWrongAndAsksForWhatIsNotRead) {
    SidePanelHarness panel(charged());
    panel.property_names = {"charge", "Mass"};
    panel.type_into("filter", "x >");
    EXPECT_TRUE(panel.has("filter fault"));
    EXPECT_NE(panel.text().find("column 4: the text ends, expected a number or a word"), std::string::npos) << panel.text();
    EXPECT_TRUE(panel.taken<RequestProperties>().empty());
    panel.click("clear filter");
    panel.type_into("filter", "speed > 1");
    EXPECT_NE(panel.text().find("the file has Mass"), std::string::npos) << panel.text();
    panel.click("clear filter");
    panel.type_into("filter", "mass > 1");
    EXPECT_FALSE(panel.taken<RequestProperties>().empty());
    EXPECT_FALSE(panel.has("filter fault"));
    panel.document.add_properties({{"Mass", std::vector<double>(125, 2.0)}});
    panel.redraws(2);
    EXPECT_EQ(panel.state().search.found().size(), 125U);
    panel.take_actions();
    panel.redraws(2);
    EXPECT_TRUE(panel.taken<RequestProperties>().empty());
}

TEST(SphereList, AFilterOfManyNamesAnswersBeforeItIsDone) {
    Scene scene = line_of_spheres(300'000);
    for (std::uint32_t i = 0; i < 300'000; ++i) {
        scene.names.emplace_hint(scene.names.end(), i, (i % 100'000 == 7 ? "Planet " : "dust ") + std::to_string(i));
    }
    SidePanelHarness panel(scene);
    panel.type_into("filter", "PLAN");
    EXPECT_TRUE(panel.has("row 7")) << "what was found so far";
    EXPECT_FALSE(panel.state().search.done());
    EXPECT_NE(panel.text().find("% looked at"), std::string::npos);
    // A move of a sphere begins nothing anew; a name does.
    const double part = panel.state().search.part();
    panel.document.apply(ChangeSpheres{{5}, {scene.spheres[6]}}, "");
    panel.redraws();
    EXPECT_GT(panel.state().search.part(), part);
    panel.document.apply(RenameSphere{8, "Planet X"}, "");
    panel.redraws();
    EXPECT_LE(panel.state().search.part(), part);
    panel.redraws(10);
    EXPECT_TRUE(panel.state().search.done());
    EXPECT_EQ(panel.state().search.found(), (Numbers{7, 8, 100'007, 200'007}));
    panel.click("select filtered");
    EXPECT_EQ(panel.selection.size(), 4U);
    panel.document.undo();
    panel.redraws(12);
    EXPECT_EQ(panel.state().search.found().size(), 3U) << "undoing a name is followed, too";
    EXPECT_EQ(panel.rows(), 3U);
    panel.document.apply(RemoveSpheres{{0, 1, 2}}, "");
    panel.redraws(12);
    EXPECT_EQ(panel.state().search.found().front(), 4U) << "a sphere that is gone counts";
}

}  // namespace

}  // namespace sphereview

#include <gtest/gtest.h>

#include <cmath>

#include "base/text.hpp"
#include "panels/harness.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

const Sphere& changed_sphere(const EditScene& edit) { return std::get<ChangeSpheres>(edit.edit).spheres.at(0); }

void drag_number(SidePanelHarness& panel, const std::string& field, float from, float to) {
    panel.drag(panel.place(field, from), panel.place(field, to));
}

void open(SidePanelHarness& panel, const std::string& field) {
    panel.click(field);
    panel.redraws(3);
}

void type_into(SidePanelHarness& panel, const std::string& field, const std::string& text, ImGuiKey key = ImGuiKey_Enter) {
    open(panel, field);
    panel.type(text);
    panel.tap(key);
}

TEST(SphereEditor, DraggingANumberChangesThatValueAloneInOneGesture) {
    for (const std::size_t which : {0U, 1U, 2U, 3U}) {
        const std::string slider = std::array{"slider x", "slider y", "slider z", "slider radius"}[which];
        SidePanelHarness panel(10, {3});
        const Sphere before = panel.sphere(3);
        drag_number(panel, slider, 0.4F, 0.8F);
        const auto edits = panel.edits_of_one_gesture();
        ASSERT_GE(edits.size(), 5U) << slider;
        for (const EditScene& edit : edits) {
            EXPECT_EQ(edit.name, which == 3 ? "Change radius of sphere 3" : "Move sphere 3");
            EXPECT_EQ(std::get<ChangeSpheres>(edit.edit).numbers, std::vector<std::uint32_t>{3});
            const Sphere& after = changed_sphere(edit);
            for (std::size_t i = 0; i < 4; ++i) {
                const auto value = static_cast<SphereValue>(i);
                EXPECT_EQ(same_bits(value_of(after, value), value_of(before, value)), i != which) << slider << " " << i;
            }
        }
        EXPECT_EQ(panel.sphere(4), line_of_spheres(10).spheres[4]);
        drag_number(panel, slider, 0.8F, 0.3F);
        EXPECT_NE(panel.edits_of_one_gesture().front().gesture, edits.front().gesture) << "each drag is a gesture of its own";
        for (int i = 0; i < 2; ++i) panel.document.undo();
        EXPECT_TRUE(same_bits(panel.sphere(3), before)) << "one step takes all of a drag back";
        EXPECT_FALSE(panel.document.can_undo());
    }
}

TEST(SphereEditor, NothingIsAskedForWhileAHeldNumberRests) {
    SidePanelHarness panel(10, {3});
    panel.expect_nothing_while_held(panel.place("slider x", 0.7F));
}

TEST(SphereEditor, DraggedValuesAreShortAndNoRadiusEndsAtNothing) {
    SidePanelHarness panel(10, {3});
    drag_number(panel, "slider x", 0.4F, 0.8F);
    EXPECT_LE(shortest(panel.sphere(3).center.x).size(), 7U) << shortest(panel.sphere(3).center.x);
    const double before = panel.sphere(3).radius;
    drag_number(panel, "slider radius", 0.5F, 0.8F);
    EXPECT_GT(panel.sphere(3).radius, 1.3 * before);
    EXPECT_LT(panel.sphere(3).radius, 3.0 * before);
    EXPECT_LE(shortest(panel.sphere(3).radius).size(), 6U);
    const ImVec2 place = panel.place("slider radius");
    panel.drag(place, {place.x - 900.0F, place.y});
    EXPECT_GT(panel.sphere(3).radius, 0.0);
    EXPECT_LT(panel.sphere(3).radius, 0.01 * before);
}

TEST(SphereEditor, AClickTypesAnyNumberInFull) {
    SidePanelHarness panel(10, {3});
    type_into(panel, "slider x", "-123456.7890123456");
    EXPECT_EQ(panel.sphere(3).center.x, -123456.7890123456);
    EXPECT_EQ(panel.document.undo_name(), "Move sphere 3");
    type_into(panel, "slider radius", " 2.5e-7 ");
    EXPECT_EQ(panel.sphere(3).radius, 2.5e-7);
    type_into(panel, "slider radius", "1e300");
    EXPECT_EQ(panel.sphere(3).radius, 1e300);
    type_into(panel, "slider y", "50+3*2");
    EXPECT_EQ(panel.sphere(3).center.y, 56.0);
    EXPECT_EQ(panel.taken<EditScene>().size(), 4U);
}

TEST(SphereEditor, TabGoesThroughTheNumbersInTheirOrder) {
    SidePanelHarness panel(10, {3});
    const auto tab = [&panel] {
        panel.tap(ImGuiKey_Tab);
        panel.redraws(3);
    };
    panel.click("name");
    for (const std::string text : {"mars", "1.5", "2.5", "3.5", "4.5", "11", "12", "13"}) {
        panel.type(text);
        tab();
    }
    const Sphere expected{{1.5, 2.5, 3.5}, 4.5, {11, 12, 13}};
    EXPECT_EQ(panel.sphere(3), expected);
    EXPECT_EQ(panel.document.scene().names.at(3), "mars");
    panel.tap(ImGuiKey_Escape);
    panel.take_actions();
    type_into(panel, "slider radius", "5.5", ImGuiKey_Tab);
    panel.redraws(3);
    panel.tap(ImGuiKey_Escape);
    EXPECT_EQ(panel.sphere(3).radius, 5.5);
    // Backwards; and what is no number is mended before it goes on.
    open(panel, "slider z");
    panel.modifiers(false, true);
    tab();
    panel.modifiers(false);
    panel.type("-2");
    panel.modifiers(false, true);
    tab();
    panel.modifiers(false);
    panel.type("nonsense");
    tab();
    EXPECT_EQ(panel.state().numbers.typed, "x");
    panel.modifiers(true);
    panel.tap(ImGuiKey_A);
    panel.modifiers(false);
    panel.type("1.75");
    tab();
    panel.type("-3");
    panel.tap(ImGuiKey_Enter);
    EXPECT_EQ(panel.sphere(3).center, glm::dvec3(1.75, -3.0, 3.5));
    EXPECT_EQ(panel.state().numbers.typed, "");
}

// What else a field refuses: number_field_test.cpp.
TEST(SphereEditor, WhatIsRefusedChangesNothing) {
    SidePanelHarness panel(10, {3});
    for (const auto& [slider, text] : {std::pair("slider x", "1e999"), std::pair("slider y", "nan"), std::pair("slider z", " "),
                                       std::pair("slider radius", "0"), std::pair("slider radius", "1e-999")}) {
        type_into(panel, slider, text);
        panel.redraws(3);
        panel.tap(ImGuiKey_Escape);
        panel.redraws(2);
        EXPECT_EQ(panel.state().numbers.typed, "") << "the number is back";
    }
    type_into(panel, "slider x", "12", ImGuiKey_Escape);
    panel.click("slider y", 1);
    EXPECT_TRUE(panel.taken<EditScene>().empty());
    EXPECT_TRUE(same_bits(panel.sphere(3), line_of_spheres(10).spheres[3]));
}

TEST(SphereEditor, ExtremeScenesAreEdited) {
    for (const double size : {1e-300, 1e-9, 1e9, 1e150, 1e300}) {
        Scene scene = scene_of({{{size, -size, size}, size}, {{-size, size, size}, 0.1 * size}});
        SidePanelHarness panel(scene);
        panel.select({1});
        for (const std::string slider : {"slider x", "slider y", "slider z", "slider radius"})
            drag_number(panel, slider, 0.3F, 0.6F);
        const Sphere& sphere = panel.sphere(1);
        EXPECT_FALSE(panel.taken<EditScene>().empty());
        for (const double value : {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius})
            EXPECT_TRUE(std::isfinite(value));
        EXPECT_GT(sphere.radius, 0.0) << size;
        EXPECT_NE(sphere, scene.spheres[1]);
    }
}

TEST(SphereEditor, ColorAndHiddenAreSetForAllThatAreSelected) {
    SidePanelHarness panel(5, {4, 1, 2});
    panel.click("hidden");
    EXPECT_EQ(panel.document.undo_name(), "Hide 3 spheres");
    for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(panel.sphere(i).hidden, i == 1 || i == 2 || i == 4) << i;
    panel.enter("blue", "77");
    EXPECT_EQ(panel.document.undo_name(), "Recolour 3 spheres");
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Color before = line_of_spheres(5).spheres[i].color;
        EXPECT_EQ(panel.sphere(i).color, (Color{before.r, before.g, i == 1 || i == 2 || i == 4 ? std::uint8_t{77} : before.b}))
            << i;
    }
}

TEST(SphereEditor, DragsMoveAllByTheSameDifferenceInOneStep) {
    for (const std::size_t which : {0U, 1U, 2U}) {
        SidePanelHarness panel(6, {5, 1, 3});  // the primary one
        drag_number(panel, std::array{"slider x", "slider y", "slider z"}[which], 0.5F, 0.8F);
        EXPECT_EQ(panel.document.undo_name(), "Move 3 spheres");
        const auto axis = static_cast<glm::length_t>(which);
        const Scene before = line_of_spheres(6);
        const double by = panel.sphere(3).center[axis] - before.spheres[3].center[axis];
        EXPECT_NE(by, 0.0);
        for (std::uint32_t i = 0; i < 6; ++i) {
            Sphere expected = before.spheres[i];
            if (i % 2 == 1) expected.center[axis] = i == 3 ? panel.sphere(3).center[axis] : expected.center[axis] + by;
            EXPECT_EQ(panel.sphere(i), expected) << which << " " << i;
        }
        panel.document.undo();
        for (std::uint32_t i = 0; i < 6; ++i) EXPECT_TRUE(same_bits(panel.sphere(i), before.spheres[i]));
        EXPECT_FALSE(panel.document.can_undo());
    }
}

TEST(SphereEditor, RadiusScalesAllByTheSameFactorAndThereAndBackIsNothing) {
    SidePanelHarness panel(6, {0, 5, 2});
    const Scene before = line_of_spheres(6);
    drag_number(panel, "slider radius", 0.9F, 0.6F);
    const double factor = panel.sphere(2).radius / before.spheres[2].radius;
    EXPECT_NE(factor, 1.0);
    for (const std::uint32_t i : {0U, 5U}) EXPECT_EQ(panel.sphere(i).radius, before.spheres[i].radius * factor);
    EXPECT_EQ(panel.sphere(1), before.spheres[1]);
    EXPECT_EQ(panel.document.undo_name(), "Change radius of 3 spheres");
    panel.document.undo();
    EXPECT_EQ(panel.document.scene(), before);
    EXPECT_FALSE(panel.document.can_undo());
}

TEST(SphereEditor, ALongDragAddsNothingUp) {
    SidePanelHarness panel(6, {1, 4, 3});
    panel.move(panel.place("slider x", 0.5F));
    panel.press();
    for (int i = 0; i < 50; ++i) panel.move(panel.place("slider x", i % 2 == 0 ? 0.2F : 0.8F));
    panel.release();
    const Scene before = line_of_spheres(6);
    const double by = panel.sphere(3).center.x - before.spheres[3].center.x;
    for (const std::uint32_t i : {1U, 4U}) EXPECT_EQ(panel.sphere(i).center.x, before.spheres[i].center.x + by) << "to the bit";
}

TEST(SphereEditor, ATypedNumberIsSetForAll) {
    SidePanelHarness panel(6, {1, 4, 3});
    type_into(panel, "slider y", "-2.5");
    for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(panel.sphere(i).center.y == -2.5, i == 1 || i == 3 || i == 4) << i;
    type_into(panel, "slider radius", shortest(panel.sphere(3).radius));  // the primary one's own
    EXPECT_EQ(panel.sphere(1).radius, panel.sphere(3).radius);
    EXPECT_EQ(panel.sphere(4).radius, panel.sphere(3).radius);
    panel.take_actions();
    type_into(panel, "slider x", "");
    EXPECT_TRUE(panel.taken<EditScene>().empty()) << "what differs stays so until a number is typed";
}

// What is typed makes the scene larger; a drag stays as it began.
TEST(SphereEditor, TypingAndDraggingInOneFrameKeepsBoth) {
    for (const bool below : {true, false}) {
        const std::string dragged = below ? "slider y" : "slider x";
        const auto drag = [&](SidePanelHarness& panel) {
            const ImVec2 from = panel.place(dragged);
            panel.drag(from, {from.x + 60.0F, from.y});
            return below ? panel.sphere(3).center.y : panel.sphere(3).center.x;
        };
        const double alone = [&] {
            SidePanelHarness panel(6, {1, 4, 3});
            return drag(panel);
        }();
        SidePanelHarness panel(6, {1, 4, 3});
        open(panel, below ? "slider x" : "slider y");
        panel.type("77.25");
        EXPECT_EQ(drag(panel), alone);
        for (const std::uint32_t i : {1U, 3U, 4U}) {
            const glm::dvec3 before = line_of_spheres(6).spheres[i].center;
            const glm::dvec3 after = panel.sphere(i).center;
            EXPECT_EQ(below ? after.x : after.y, 77.25);
            EXPECT_NE(below ? after.y : after.x, below ? before.y : before.x);
        }
    }
}

TEST(SphereEditor, ManyAreSummedUp) {
    Scene scene = line_of_spheres(5);
    scene.spheres[2].color = {1, 2, 3};
    scene.spheres[1].hidden = true;
    SidePanelHarness panel(scene);
    panel.select({0, 3, 4});
    std::string text = panel.text();
    EXPECT_NE(text.find("3 spheres. "), std::string::npos) << text;
    EXPECT_NE(text.find("0 to 1.33"), std::string::npos) << text;
    panel.selection.set({0, 1, 2});
    text = panel.text();
    EXPECT_NE(text.find("3 spheres, of several colours, 1 hidden. "), std::string::npos) << text;
    EXPECT_NE(text.find("Hide"), std::string::npos) << "what H will do, some being shown";
    EXPECT_FALSE(panel.has("name"));
    panel.click("hidden");
    for (const std::uint32_t i : {0U, 1U, 2U}) EXPECT_TRUE(panel.sphere(i).hidden) << "some were: now all are";
    EXPECT_NE(panel.text().find("all hidden"), std::string::npos);
    panel.click("hidden");
    for (const std::uint32_t i : {0U, 1U, 2U}) EXPECT_FALSE(panel.sphere(i).hidden);
}

TEST(SphereEditor, TheButtonSaysWhatTheCommandDoes) {
    Scene scene = line_of_spheres(3);
    scene.spheres[1].hidden = true;
    SidePanelHarness panel(scene);
    const auto says = [&](std::initializer_list<std::uint32_t> numbers, const std::string& word) {
        panel.selection.set(numbers);
        return panel.text().find("[ " + word + " ]") != std::string::npos;
    };
    EXPECT_TRUE(says({0, 1}, "Hide")) << "the primary one is hidden, the other is not";
    EXPECT_TRUE(says({1}, "Show"));
    EXPECT_TRUE(says({}, "Hide"));
    EXPECT_TRUE(says({0}, "Hide"));
}

TEST(SphereEditor, ItsHeadingSaysWhichSphereItIs) {
    Scene scene = line_of_spheres(5);
    scene.names[2] = "C";
    SidePanelHarness panel(scene);
    const auto says = [&](const std::vector<std::uint32_t>& numbers, const std::string& words) {
        panel.select(numbers);
        return panel.text().find(words) != std::string::npos;
    };
    EXPECT_TRUE(says({2}, "Sphere 2 'C'"));
    EXPECT_TRUE(says({2}, "5 spheres, 1 selected"));
    EXPECT_TRUE(says({3}, "Sphere 3"));
    EXPECT_FALSE(says({2, 3}, "Sphere 2"));
    panel.state().filter = "C";
    EXPECT_TRUE(says({2, 3}, "1 of 5 spheres, 2 selected"));
}

TEST(SphereEditor, NameIsTyped) {
    SidePanelHarness panel(5, {2});
    panel.type_into("name", "venus");
    EXPECT_TRUE(panel.document.scene().names.empty()) << "not before it is done";
    panel.click("row 4");
    EXPECT_EQ(panel.document.scene().names.at(2), "venus");
    EXPECT_EQ(panel.selection.primary(), 4U);
    EXPECT_EQ(panel.document.scene().names.size(), 1U);
    panel.select({2});
    panel.type_into("name", "x");
    panel.tap(ImGuiKey_Escape);
    EXPECT_EQ(panel.document.scene().names.at(2), "venus");
}

TEST(SphereEditor, SelectionThatTheSceneDoesNotHaveIsNotShown) {
    SidePanelHarness panel(5, {4});
    EXPECT_TRUE(panel.has("slider x"));
    panel.applies = false;
    panel.document.apply(RemoveSpheres{{3, 4}}, "");
    panel.redraws(2);
    EXPECT_FALSE(panel.has("slider x"));
}

}  // namespace

}  // namespace sphereview

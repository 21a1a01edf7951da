// Dialogs and the side panel without a window.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "panels/dialogs.hpp"
#include "panels/side_panel.hpp"
#include "support/panel_harness.hpp"
#include "support/spheres.hpp"

namespace sphereview {

struct DialogHarness {
    Dialogs dialogs;
    DialogKeys keys;
    PanelHarness panels{[this](const PanelContext& context) { draw_dialogs(context, dialogs, std::exchange(keys, {})); }};

    // Puts a dialog on top and waits until it has its place.
    void put(Dialog dialog) {
        dialogs.push_back(std::move(dialog));
        panels.redraws(4);
    }
    void enter() { press({.enter = true}); }
    void escape() { press({.escape = true}); }
    void step(int by) { press({.step = by}); }
    void press(DialogKeys pressed) {
        keys = pressed;
        panels.redraws(4);
    }
    void click(const std::string& widget) {
        panels.click(widget);
        panels.redraws(4);
    }
    // In a text box: what was there before is replaced.
    void type_over(const std::string& widget, const std::string& text) {
        panels.click(widget);
        panels.modifiers(true);
        panels.tap(ImGuiKey_A);
        panels.modifiers(false);
        panels.tap(ImGuiKey_Backspace);
        panels.type(text);
    }
    void enter_over(const std::string& widget, const std::string& text) {
        type_over(widget, text);
        enter();
    }
    void double_click(const std::string& widget) {
        panels.double_click(widget);
        panels.redraws(4);
    }
    template <typename Kind>
    Kind& top() {
        return std::get<Kind>(dialogs.back());
    }
    std::string top_id() const { return dialogs.empty() ? "" : id_of(dialogs.back()); }
};

// Spheres 0, 1, 2, ... in a line, with values that no slider gives.
inline Scene line_of_spheres(std::size_t count) {
    Scene scene = scene_of_alike(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<double>(i);
        scene.spheres[i] = {{x / 3.0, x / 7.0 - 5.0, 200.0 + x / 11.0}, 1.0 + x / 13.0, {10, 20, 30}};
    }
    return scene;
}

// A base, so that it is there when PanelHarness draws for the first time.
struct HeldSidePanel {
    SidePanelState held;
};

class SidePanelHarness : private HeldSidePanel, public PanelHarness {
public:
    explicit SidePanelHarness(Scene scene, float height = 700.0F)
        : PanelHarness(in_window([this](const PanelContext& context) { draw_side_panel(context, state()); }, 340.0F, height),
                       std::move(scene), 1400.0F, 1200.0F) {
        take_actions();
    }
    SidePanelHarness(std::size_t count, const std::vector<std::uint32_t>& selected) : SidePanelHarness(line_of_spheres(count)) {
        select(selected);
    }

    SidePanelState& state() { return held; }

    // Selects as a click does, without one.
    void select(const std::vector<std::uint32_t>& numbers) {
        selection.set(numbers);
        redraws(2);
    }
    void type_into(const std::string& widget, const std::string& text) {
        click(widget);
        type(text);
    }
    void begin_renaming(std::uint32_t number, const std::string& typed) {
        start_renaming(state(), document.scene(), number);
        redraws(4);
        ASSERT_TRUE(has("rename"));
        type(typed);
    }
    void undo() {
        document.undo();
        redraws();
    }
    void expect_selected(const std::vector<std::uint32_t>& numbers) const { EXPECT_EQ(selection.numbers(), numbers); }
    const Sphere& sphere(std::uint32_t number) const { return document.scene().spheres.at(number); }

    // In a number's field, which a click opens.
    void enter(const std::string& number, const std::string& text) {
        click("slider " + number);
        redraws(3);
        type(text);
        tap(ImGuiKey_Enter);
        move({1000.0F, 900.0F});  // no tooltip, which would end the text
    }
    void drag_by(const std::string& number, float pixels) {
        const ImVec2 from = place("slider " + number);
        drag(from, {from.x + pixels, from.y});
    }

    // The edits since the last call: some, all of one gesture.
    std::vector<EditScene> edits_of_one_gesture() {
        std::vector<EditScene> edits = taken<EditScene>();
        EXPECT_FALSE(edits.empty());
        for (const EditScene& edit : edits) EXPECT_TRUE(edit.gesture != 0 && edit.gesture == edits.front().gesture);
        return edits;
    }

    // That what is held without moving, and let go, asks for nothing.
    void expect_nothing_while_held(ImVec2 held_place) {
        move(held_place);
        press();
        redraws(2);
        take_actions();
        redraws(5);
        release();
        redraws(2);
        EXPECT_TRUE(take_actions().empty());
    }

    // How many rows were drawn.
    std::size_t rows() const {
        std::size_t count = 0;
        for (const auto& [name, rectangle] : rectangles) count += name.starts_with("row ") && name.ends_with(" eye") ? 1U : 0U;
        return count;
    }
};

// With a part of the panel open that is closed at first, and three spheres.
struct OpenPartHarness : SidePanelHarness {
    // `set` makes the scene.
    template <typename Set>
    OpenPartHarness(const std::string& part, const Set& set, float height = 700.0F) : SidePanelHarness(scene_with(set), height) {
        click(part);
        redraws(2);
        take_actions();
    }

    template <typename Set>
    static Scene scene_with(const Set& set) {
        Scene scene = line_of_spheres(3);
        set(scene);
        return scene;
    }
};

}  // namespace sphereview

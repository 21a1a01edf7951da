// Dialogs without a window.
#pragma once

#include <string>
#include <utility>

#include "panels/dialogs.hpp"
#include "support/panel_harness.hpp"

namespace sphereview {

struct DialogHarness {
    Dialogs dialogs;
    DialogKeys keys;
    PanelHarness panels{[this](const PanelContext& context) { draw_dialogs(context, dialogs, std::exchange(keys, {})); }};

    // Puts a dialog on top and waits until it has its place.
    void put(Dialog dialog) {
        dialogs.push_back(std::move(dialog));
        panels.frames(4);
    }
    void enter() { press({.enter = true}); }
    void escape() { press({.escape = true}); }
    void step(int by) { press({.step = by}); }
    void press(DialogKeys pressed) {
        keys = pressed;
        panels.frames(4);
    }
    void click(const std::string& widget) {
        panels.click(widget);
        panels.frames(4);
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
    template <typename Kind>
    Kind& top() {
        return std::get<Kind>(dialogs.back());
    }
    std::string top_id() const { return dialogs.empty() ? "" : id_of(dialogs.back()); }
};

}  // namespace sphereview

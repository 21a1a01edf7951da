// Whom the window's keys are for.
#include "viewer/event_routing.hpp"

#include <gtest/gtest.h>

#include "support/panel_harness.hpp"

namespace sphereview {

namespace {

struct RoutedWindow {
    PanelHarness imgui{[](const PanelContext&) {}};
    ViewerState state{{}, {}};
    MouseControl mouse;
    Pacing pacing;
    InputQueue input;
    EventRouting routing{state, mouse, pacing};

    // The actions that a key gives.
    std::vector<Action> press(const std::string& key) {
        input.add({KeyChanged{key, true, false, {}}, KeyChanged{key, false, false, {}}});
        std::vector<Action> actions;
        DialogKeys keys;
        while (!input.empty()) routing.take(input, keys, actions);
        return actions;
    }
};

}  // namespace

TEST(EventRouting, EscapeEndsTheTopmostThingAlone) {
    RoutedWindow window;
    ViewerState& state = window.state;
    state.help_shown = true;
    state.comparison.emplace();
    state.pins.first.emplace();
    state.measuring.on = true;
    const auto shown = [&] {
        return std::vector<bool>{state.help_shown, state.comparison->view.open, state.pins.first.has_value(), state.measuring.on};
    };
    for (const auto& left : {std::vector{false, true, true, true},
                             {false, false, true, true},
                             {false, false, false, true},
                             {false, false, false, false}}) {
        EXPECT_TRUE(window.press("escape").empty());
        EXPECT_EQ(shown(), left);
    }
    Scene one;
    one.spheres.emplace_back();
    state.document = Document(std::move(one));
    state.selection.set_all(1);
    const std::vector<Action> actions = window.press("escape");
    ASSERT_EQ(actions.size(), 1U);
    EXPECT_EQ(std::get<RunCommand>(actions[0]).command, CommandId::select_none);
}

TEST(EventRouting, PressesThatWaitGoThroughFramesInOneRedraw) {
    RoutedWindow window;
    window.state.path = "/frames.xyz";
    window.state.frames = 100;
    window.state.frame = 50;
    const auto redraws = [&](const char* name) {
        for (int i = 0; i < 20; ++i) window.input.add({KeyChanged{name, true, false, {}}, KeyChanged{name, false, false, {}}});
        std::vector<Action> actions;
        DialogKeys keys;
        int count = 0;
        for (; !window.input.empty(); ++count) window.routing.take(window.input, keys, actions);
        EXPECT_EQ(actions.size(), 20U);
        return count;
    };
    EXPECT_EQ(redraws("page up"), 1);
    EXPECT_EQ(redraws("page down"), 1);
}

TEST(EventRouting, APanelThatIsNotDrawnHoldsNoKeys) {
    RoutedWindow window;
    window.state.side_panel.list_has_keys = true;
    EXPECT_TRUE(window.press("home").empty()) << "the list's";
    window.state.panel_drawn = false;
    EXPECT_EQ(window.press("home").size(), 1U);
}

}  // namespace sphereview

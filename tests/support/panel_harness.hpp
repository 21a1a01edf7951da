// Panels without a window: an ImGui context of its own, a simulated mouse and keyboard, and a document that the panels' actions
// change as the viewer does.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// The viewer's commands, all enabled and none checked.
std::vector<CommandInfo> all_commands();

// Every call that moves or presses something draws at least one redraw. One harness lives at a time.
class PanelHarness {
public:
    using Draw = std::function<void(const PanelContext&)>;

    // `draw` is called once a redraw. Without windows of its own it should be in_window(...).
    explicit PanelHarness(Draw draw, Scene scene = {}, float width = 800.0F, float height = 600.0F);
    ~PanelHarness();
    PanelHarness(const PanelHarness&) = delete;
    PanelHarness& operator=(const PanelHarness&) = delete;

    // What a panel that draws into the current window is put into: one without a title, at the top left.
    static Draw in_window(Draw draw, float width, float height);

    // As the viewer has them. The rectangles are those of the last redraw.
    Document document;
    Selection selection;
    std::uint64_t gesture = 0;
    std::optional<std::uint32_t> hovered;  // as the last redraw left it
    WidgetRectangles rectangles;
    std::vector<CommandInfo> commands = all_commands();
    float scale = 1.0F;
    std::int64_t frame_of_file = 0;
    std::int64_t frames_of_file = 1;
    std::vector<std::string> property_names;
    // Whether EditScene and SelectSpheres are done after each redraw, as in the viewer; all actions are collected anyway.
    bool applies = true;

    void redraws(int count = 1);
    // Lets so much time pass that the next click belongs to no double click.
    void wait();
    // All actions since the last call.
    std::vector<Action> take_actions() { return std::exchange(actions_, {}); }
    // The actions of one kind among those since the last call of take_actions().
    template <typename Kind>
    std::vector<Kind> taken() {
        std::vector<Kind> found;
        for (const Action& action : take_actions()) {
            if (const Kind* kind = std::get_if<Kind>(&action)) found.push_back(*kind);
        }
        return found;
    }
    // The commands among the actions since the last call of take_actions().
    std::vector<CommandId> commands_taken();
    const SceneBounds& bounds() const { return bounds_; }
    // The view: the scene's camera unless it was moved.
    Camera view() const { return moved_view.value_or(document.scene().camera); }
    std::optional<Camera> moved_view;

    bool has(const std::string& widget) const { return rectangles.contains(widget); }
    // The place in a widget, (0.5, 0.5) its middle. A widget that the last redraw did not draw fails the test.
    ImVec2 place(const std::string& widget, float across = 0.5F, float down = 0.5F) const;

    void move(ImVec2 place);
    void press(int button = 0);
    void release(int button = 0);
    void wheel(float clicks);
    void click(ImVec2 place, int button = 0);
    void click(const std::string& widget, int button = 0) { click(place(widget), button); }
    void double_click(const std::string& widget);
    // With the left button, in so many steps, a redraw each.
    void drag(ImVec2 from, ImVec2 to, int steps = 8);

    // Held until let_go().
    void hold(ImGuiKey key);
    void let_go(ImGuiKey key);
    void tap(ImGuiKey key);
    void type(const std::string& utf8);
    // Modifiers stay until set otherwise.
    void modifiers(bool ctrl, bool shift = false);

    // One more redraw, as text: what the first window that it ends says, also where that is scrolled out of view.
    std::string text();
    // Of the last redraw: how much was drawn.
    int vertices() const;

private:
    void redraw(double seconds);
    void set_key(ImGuiKey key, bool down);

    Draw draw_;
    SceneBounds bounds_;
    std::vector<Action> actions_;
    std::string clipboard_;
    bool logging_ = false;
};

}  // namespace sphereview

// Whom the window's events are for: a shortcut's command, a box that is typed into, a menu, a dialog, or what Escape ends.
#pragma once

#include <utility>
#include <vector>

#include "viewer/input_queue.hpp"
#include "viewer/mouse_control.hpp"
#include "viewer/pacing.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

// A menu or a colour picker is open. Dialogs have keys of their own.
bool has_popped_up(const ViewerState& state);

class EventRouting {
public:
    EventRouting(ViewerState& state, const MouseControl& mouse, Pacing& pacing) : state_(state), mouse_(mouse), pacing_(pacing) {}

    // Takes the events of one redraw: does what concerns the window as a whole, appends the commands of shortcuts to `actions`,
    // notes the dialogs' keys, and returns what is ImGui's.
    std::vector<InputEvent> take(InputQueue& input, DialogKeys& keys, std::vector<Action>& actions);

    // Commands that came while a box was typed into: what it holds is to be taken before they are done.
    bool waits_for_typing() const { return !after_typing_.empty(); }
    std::vector<Action> take_after_typing() { return std::exchange(after_typing_, {}); }

private:
    // Escape ends the topmost thing alone. Returns whether that is another thing than the selection; keys.escape is left to those
    // who ask for it themselves: dialogs, the mouse, work.
    bool is_escape_for_another(bool typing, bool popped_up, DialogKeys& keys);
    // Whether the list of spheres has the key.
    bool is_of_list(const KeyChanged& key) const;
    // Whether Alt was pressed and let go with nothing between.
    bool is_lone_alt(const InputEvent& event);

    ViewerState& state_;
    const MouseControl& mouse_;
    Pacing& pacing_;
    bool alt_alone_ = false;  // Alt is down, and nothing came after it
    int waited_for_box_ = 0;  // redraws
    std::vector<Action> after_typing_{};
};

}  // namespace sphereview

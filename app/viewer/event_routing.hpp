// Routes the window's events to a shortcut's command, a text field, a menu, a dialog, or whatever Escape ends.
#pragma once

#include <utility>
#include <vector>

#include "viewer/input_queue.hpp"
#include "viewer/mouse_control.hpp"
#include "viewer/pacing.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

// Whether a menu or a colour picker is open. Dialogs have keys of their own.
bool has_popped_up(const ViewerState& state);

class EventRouting {
public:
    EventRouting(ViewerState& state, const MouseControl& mouse, Pacing& pacing) : state_(state), mouse_(mouse), pacing_(pacing) {}

    // Takes the events of one redraw: acts on those for the whole window, appends the commands of shortcuts to `actions`, notes the
    // dialogs' keys, and returns ImGui's events.
    std::vector<InputEvent> take(InputQueue& input, DialogKeys& keys, std::vector<Action>& actions);

    // Whether commands wait until the typed text is taken over.
    bool waits_for_typing() const { return !after_typing_.empty(); }
    std::vector<Action> take_after_typing() { return std::exchange(after_typing_, {}); }

private:
    // Lets Escape end the topmost thing alone. Returns whether that is something other than the selection. Leaves keys.escape to
    // dialogs, the mouse and work, which ask for it themselves.
    bool is_escape_for_another(bool typing, bool popped_up, DialogKeys& keys);
    // Whether the key is for the list of spheres.
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

// Input in portions that one redraw can take.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "platform/window.hpp"

namespace sphereview {

// ImGui 1.86 sees only the state at each redraw: two changes of one button between two redraws, or a press and a move after it,
// would be lost or misplaced. So a redraw gets events only up to the first that hides an earlier one; the rest waits for the next
// redraw. Letters that are typed come together, a held key's repeats that have come meanwhile count once, and presses of a key
// that does the same thing again add up. For this reason
// ImGui's GLFW backend is not used; its OpenGL backend is.
class InputQueue {
public:
    void add(std::vector<InputEvent> events);
    bool empty() const { return events_.empty(); }

    // `keys_wait`: what is typed, and all that follows it, stays for a later redraw. `adds_up`: whether a redraw can take several
    // presses of that key, because no widget of ImGui's asks for it.
    using AddsUp = std::function<bool(const KeyChanged&)>;
    std::vector<InputEvent> take(bool keys_wait = false, const AddsUp& adds_up = {});

private:
    std::deque<InputEvent> events_;
};

}  // namespace sphereview

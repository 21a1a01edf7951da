// Input in portions that one frame can take.
#pragma once

#include <deque>
#include <vector>

#include "platform/window.hpp"

namespace sphereview {

// Immediate-mode widgets see only the state at each frame: two changes of one button between two frames, or a press and a
// move after it, would be lost or misplaced. So a frame gets events only up to the first that hides an earlier one; the rest waits
// for the next frame.
class InputQueue {
public:
    void add(std::vector<InputEvent> events);
    bool empty() const { return events_.empty(); }

    std::vector<InputEvent> take_frame();

private:
    std::deque<InputEvent> events_;
};

}  // namespace sphereview

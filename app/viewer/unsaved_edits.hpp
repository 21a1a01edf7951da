// What becomes of unsaved changes when the program ends unasked.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace sphereview {

struct ViewerState;

// Keeps them for the next start, and says what became of them, for a message; "" when there are none.
std::string keep_unsaved(const ViewerState& state);

// The same by another thread than that of the loop, which hangs. Should the loop go on meanwhile, it changes nothing until the
// process has ended. Nothing when the loop is in the middle of a change for longer than that.
std::optional<std::string> keep_unsaved_of_hung_loop(ViewerState& state, std::chrono::milliseconds limit);

}  // namespace sphereview

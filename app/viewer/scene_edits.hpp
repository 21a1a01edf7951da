// The edits behind the commands of the Edit menu.
#pragma once

#include "viewer/viewer_state.hpp"

namespace sphereview {

// A sphere of usual size in the middle of the view, in front of what is there.
EditScene add_sphere(const ViewerState& state);

// Each needs something selected.
EditScene duplicate_selected(const ViewerState& state);
EditScene remove_selected(const ViewerState& state);
// Hides them if any is shown, else shows them.
EditScene hide_or_show_selected(const ViewerState& state);
// By one place in the list, up (-1) or down (1); needs one sphere and a place to go to.
EditScene reorder_selected(const ViewerState& state, int by);

}  // namespace sphereview

// The edits that commands make of what is selected and of the view.
#pragma once

#include "panels/panel_context.hpp"

namespace sphereview {

struct ViewerState;

// A sphere of usual size in the middle of the view, or beside what is there.
EditScene add_sphere(const ViewerState& state);

// The others need something selected.
EditScene duplicate_selected(const ViewerState& state);
EditScene remove_selected(const ViewerState& state);
// Hides them if any is shown, else shows them.
EditScene hide_or_show_selected(const ViewerState& state);
// By one place in the list; needs one sphere and a place to go to.
EditScene move_up(const ViewerState& state);
EditScene move_down(const ViewerState& state);

}  // namespace sphereview

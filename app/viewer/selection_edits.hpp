// The edits of commands, made from the selection and the view.
#pragma once

#include "panels/panel_context.hpp"

namespace sphereview {

struct ViewerState;

// Adds a sphere of usual size in the middle of the view, or beside spheres there.
EditScene add_sphere(const ViewerState& state);

// The others need something selected.
EditScene duplicate_selected(const ViewerState& state);
EditScene remove_selected(const ViewerState& state);
// Hides them if any is shown, else shows them.
EditScene hide_or_show_selected(const ViewerState& state);
// Move by one place in the list; need a single selected sphere that can move.
EditScene move_up(const ViewerState& state);
EditScene move_down(const ViewerState& state);

}  // namespace sphereview

// The edits of commands, made from the selection and the view; and spheres on the clipboard as the text of a scene, for windows and
// editors.
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

// Puts the selected spheres on the clipboard: in the text format, or, where a sphere is hidden or has a name, in the native one.
// Returns whether that worked; if not, an announcement says why.
bool copy_selected(ViewerState& state);

// Copies the selected spheres, then deletes them, as one step.
void cut_selected(ViewerState& state);

// Adds the spheres on the clipboard, as one step, and selects them. They keep their places; if a sphere would equal one in centre
// and radius, all are moved aside. An announcement says that, or why nothing was pasted.
void paste(ViewerState& state);

}  // namespace sphereview

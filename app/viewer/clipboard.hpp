// Spheres on the clipboard as the text of a scene, for windows and editors.
#pragma once

#include "viewer/viewer_state.hpp"

namespace sphereview {

// Puts the selected spheres on the clipboard: in the text format, or, where a sphere is hidden or has a name, in the native one.
// Returns whether that worked; if not, an announcement says why.
bool copy_selected(ViewerState& state);

// Copies the selected spheres, then deletes them, as one step.
void cut_selected(ViewerState& state);

// Adds the spheres on the clipboard, as one step, and selects them. They keep their places; if a sphere would equal one in centre
// and radius, all are moved aside. An announcement says that, or why nothing was pasted.
void paste(ViewerState& state);

}  // namespace sphereview

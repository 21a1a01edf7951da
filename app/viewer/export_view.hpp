// PNG files of what the window shows: where they go. viewer/picture_job.hpp makes them.
#pragma once

#include "viewer/viewer_state.hpp"

namespace sphereview {

// F12: to the next free name beside the scene, or in the Pictures folder. Does nothing while another export is on its way.
void export_now(ViewerState& state);

// File > Export: asks for name and size, and before it overwrites.
void ask_for_export(ViewerState& state);

}  // namespace sphereview

// PNG files of what the window shows.
#pragma once

#include <string>

#include "viewer/viewer_state.hpp"

namespace sphereview {

// Writes the certified picture of the view, byte for byte what `render --samples N` makes of the scene saved with the view as its
// camera. Throws what rendering and writing do.
void export_view(const ViewerState& state, const std::string& path, PictureSize size);

// F12: at once, to the next free name beside the scene, or in the Pictures folder.
void export_now(ViewerState& state);

// File > Export: asks for name and size, and before it overwrites.
void ask_for_export(ViewerState& state);

}  // namespace sphereview

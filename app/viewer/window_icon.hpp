// The window's icon, drawn by the tracer itself.
#pragma once

#include <vector>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The scene of packaging/icon.toml, of which the installed icons are pictures.
Scene icon_scene();

// In the sizes that desktops ask for, RGBA.
std::vector<Image> window_icons();

}  // namespace sphereview

// The window's icon, drawn by the tracer itself.
#pragma once

#include <vector>

#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The scene of packaging/icon.toml, from which the installed icons are rendered.
Scene icon_scene();

// The icons in the sizes that desktops ask for, RGBA.
std::vector<Image> window_icons();

}  // namespace sphereview

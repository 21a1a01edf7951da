// Trying one backend for real, in this process. The functions throw RenderError where it does not work.
#pragma once

#include <cstddef>

#include "app/json.hpp"

namespace sphereview {

// What EGL offers: {"devices": [{"name", "device", "software"}]}.
Json list_egl();

// These render a small scene and check every pixel: {"works": true, "renderer", ...limits}. index: into list_egl().
Json probe_egl(std::size_t index);
Json probe_osmesa();
Json probe_cpu();

}  // namespace sphereview

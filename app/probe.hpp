// Trying one backend for real, in this process. The functions throw RenderError where it does not work.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace sphereview {

// What EGL offers: {"devices": [{"name", "device", "software"}]}.
nlohmann::ordered_json list_egl();

// These render a small scene and check every pixel: {"works": true, "renderer", ...limits}. index: into list_egl().
nlohmann::ordered_json probe_egl(std::size_t index);
nlohmann::ordered_json probe_osmesa();
nlohmann::ordered_json probe_cpu();

}  // namespace sphereview

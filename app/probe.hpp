// Trying one backend for real, in this process.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace sphereview {

// Does what a child process of `doctor` is for and returns its result for the parent:
// "egl" lists what EGL offers, {"devices": [{"name", "device", "software"}]} or {"reason"};
// "egl N" (an index into that list), "osmesa" and "cpu" render a small scene and check every pixel:
// {"works": true, "renderer", ...limits} or {"works": false, "reason"}.
nlohmann::ordered_json probe(const std::string& what);

}  // namespace sphereview

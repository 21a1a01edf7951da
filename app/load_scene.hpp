// From a path to a scene.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A scene and how messages call the file it came from.
struct LoadedScene {
    Scene scene;
    std::string name;
};

// Reads a scene file of any format, or standard input for "-"; of a text, only a small part is in memory at a time. Throws
// InputError, and MemoryError when it cannot fit.
LoadedScene load_scene(const std::string& path, Progress* progress = nullptr);

}  // namespace sphereview

// From a path to a scene.
#pragma once

#include <cstddef>
#include <string>

#include "base/progress.hpp"
#include "scene/scene.hpp"
#include "scene/scene_format.hpp"

namespace sphereview {

// A scene and how messages call the file it came from.
struct LoadedScene {
    Scene scene;
    std::string name;
    SceneFormat format = SceneFormat::text;
};

// Reads a scene file of any format, or standard input for "-"; of a text, only a small part is in memory at a time. Throws
// InputError, and MemoryError when it cannot fit: a sphere takes its own bytes and `more_per_sphere` for what is to be made of
// it.
LoadedScene load_scene(const std::string& path, Progress* progress = nullptr, std::size_t more_per_sphere = 0);

}  // namespace sphereview

// From a path to a scene.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace sphereview {

// A scene and how messages call the file it came from.
struct LoadedScene {
    Scene scene;
    std::string name;
};

// Reads a scene file of any format, or standard input for "-"; gives back the memory of the text while it reads.
// Throws InputError.
LoadedScene load_scene(const std::string& path);

}  // namespace sphereview

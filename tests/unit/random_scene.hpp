// Scenes that try to be misread.
#pragma once

#include <random>

#include "scene/scene.hpp"

namespace sphereview {

// A valid scene: doubles of any bit pattern that is finite, names with quotes, control characters and UTF-8, any background,
// a camera of any scale. The same random numbers give the same scene on every platform.
Scene random_scene(std::mt19937_64& random);

}  // namespace sphereview

// Scenes that try to be misread.
#pragma once

#include <cstddef>
#include <random>

#include "scene/scene.hpp"

namespace sphereview {

// By chance, without std's distributions, which differ between standard libraries.
inline std::size_t below(std::mt19937_64& random, std::size_t count) { return static_cast<std::size_t>(random() % count); }
inline bool one_in(std::mt19937_64& random, std::size_t count) { return below(random, count) == 0; }

// A valid scene: doubles of any bit pattern that is finite, names with quotes, control characters and UTF-8, any background,
// a camera of any scale. The same random numbers give the same scene on every platform.
Scene random_scene(std::mt19937_64& random);

}  // namespace sphereview

// Scenes of any number of spheres, the same for the same seed.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "scene/scene.hpp"

namespace sphereview {

// How large the spheres are; their centres are uniform in the frustum 200 < z < 1000, |x|, |y| < 0.48 z, which the default
// camera sees.
enum class SceneSet {
    volume,  // radius 130 N^(-1/3), within 0.3 .. 60: they fill the same part of the space
    half     // radius 289 N^(-1/2), within 0.25 .. 60: they cover the same part of the picture
};

std::optional<SceneSet> scene_set_named(std::string_view name);

Scene random_scene(SceneSet set, std::size_t count, std::uint64_t seed = 1);

}  // namespace sphereview

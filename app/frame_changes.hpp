// What a person has changed of spheres in one frame of a file, for all of its frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Of the sphere with that number; what is not said stays as it is.
struct SphereChange {
    std::uint32_t number = 0;
    std::optional<bool> hidden{};
    std::optional<Color> color{};
    std::optional<double> radius{};

    bool operator==(const SphereChange&) const = default;
};

struct FrameChanges {
    std::size_t frame_size = 0;           // frames of so many spheres get
    std::vector<SphereChange> spheres{};  // these
    std::optional<Light> light{};
};

// In what colours, radii and what is hidden differ; places are each frame's own. Of as many spheres in the same order.
std::vector<SphereChange> changes_between(const std::vector<Sphere>& before, const std::vector<Sphere>& after);

// Each makes its part of the changes: the first before the look, whose ranges count no hidden spheres, the other after it.
void hide_and_light(Scene& frame, const FrameChanges& changes);
void color_and_size(Scene& frame, const FrameChanges& changes);

}  // namespace sphereview

// What a person has changed of spheres in one frame of a file, for all of its frames.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Of the sphere with that number, in each frame that has one; what is not said stays as it is.
struct SphereChange {
    std::uint32_t number = 0;
    std::optional<bool> hidden{};
    std::optional<Color> color{};
    std::optional<double> radius{};

    bool operator==(const SphereChange&) const = default;
};

struct FrameChanges {
    std::vector<SphereChange> spheres{};
    std::optional<Light> light{};
};

// How colours, radii and what is hidden differ between a frame as its file has it and as it is shown. Places are each frame's own.
// Both must have the same spheres, in the same order.
std::vector<SphereChange> changes_between(const std::vector<Sphere>& file, const std::vector<Sphere>& shown);

// Each makes its part of the changes: the first before the look, whose ranges count no hidden spheres, the other after it.
void hide_and_light(Scene& frame, const FrameChanges& changes);
void color_and_size(Scene& frame, const FrameChanges& changes);

}  // namespace sphereview

// Which lights shine on what the pixels show, by the definition alone: for every pixel, light and sphere the line to the light is
// intersected in exact arithmetic. Shares no code with src/light and src/exact.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview::oracle {

// The choices in the definition of light. All but the defaults are wrong; the tests show that they are noticed.
struct LightRules {
    bool tangent_blocks = true;          // else a line that only touches a sphere goes on
    bool edge_is_dark = true;            // else a light in the surface's tangent plane shines
    bool spheres_of_eye_block = false;   // those that hold the eye
    bool only_towards_the_light = true;  // else spheres behind the point block, too
    bool normal_turned_to_eye = true;    // else it always points away from the centre
    bool hidden_blocks = false;
};

// For one pixel that shows the sphere `number`: whether the light shines, of each of the directions.
std::vector<bool> shines(const Scene& scene, PictureSize size, Pixel pixel, std::int32_t number,
                         std::span<const glm::dvec3> directions, const LightRules& rules = {});

}  // namespace sphereview::oracle

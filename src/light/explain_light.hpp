// Whether one light shines on what a pixel shows, and which sphere keeps it away, and why.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "exact/drawn.hpp"
#include "exact/exact_light.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct LightExplanation {
    int facing = 0;                       // the sign of n.L
    std::optional<std::int32_t> blocker;  // the first sphere of the scene that blocks the light, if n.L > 0
    BlockingSigns signs;                  // the blocker's

    bool shines() const { return facing > 0 && !blocker; }
};

// Of a pixel inside the picture that the scene's camera sees, which shows the sphere `visible`; of spheres drawn
// without edits.
LightExplanation explain_light(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, Pixel pixel, std::int32_t visible,
                               const glm::dvec3& direction);

// "shines", or why the light does not.
std::string in_words(const LightExplanation& explanation);

}  // namespace sphereview

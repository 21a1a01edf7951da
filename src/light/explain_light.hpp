// Whether lights shine on what a pixel shows, and which spheres keep them away, and why.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/drawn.hpp"
#include "exact/exact_light.hpp"
#include "light/light_set.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A pixel inside the picture that a camera sees, and the sphere that it shows.
struct LitPixel {
    const Scene& scene;
    const DrawnSpheres& drawn;  // as the camera sees them
    const Camera& camera;
    PictureSize size;
    Pixel pixel;
    std::int32_t visible;
};

struct LightExplanation {
    int facing = 0;                       // the sign of n.L
    std::optional<std::int32_t> blocker;  // the first sphere of the scene that blocks the light, if n.L > 0
    BlockingSigns signs;                  // the blocker's

    bool shines() const { return facing > 0 && !blocker; }
};

LightExplanation explain_light(const LitPixel& pixel, const glm::dvec3& direction);

// "shines", or why the light does not.
std::string in_words(const LightExplanation& explanation);

// What becomes of many lights.
struct SkyExplanation {
    struct Blocker {
        std::int32_t number = 0;
        int lights = 0;  // that it keeps away, perhaps with others
    };

    int lights = 0;
    int shining = 0;
    int behind = 0;                 // n.L <= 0
    int blocked = 0;                // the others
    std::vector<Blocker> blockers;  // those that keep most lights away, the worst first
};

SkyExplanation explain_sky(const LitPixel& pixel, std::span<const DirectedLight> lights);

// "37 of 64 lights shine; ..."
std::string in_words(const SkyExplanation& explanation);

}  // namespace sphereview

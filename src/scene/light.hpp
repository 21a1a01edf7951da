// What lights a scene in the shading `studio`: a sky all round with a soft key light in it, and perhaps a sun.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace sphereview {

inline constexpr int fewest_lights = 16;
inline constexpr int most_lights = 1024;
inline constexpr double most_sky = 1.0;
inline constexpr double most_key = 1.0;
// At least so strong that the sun's share of the light is more than what its rounding takes away.
inline constexpr double weakest_sun = 0.001;
inline constexpr double strongest_sun = 4.0;

// One hard light, infinitely far away.
struct Sun {
    glm::dvec3 direction{0.0, 1.0, 0.0};  // from the scene to the sun, of any length: finite and not zero
    double strength = 1.0;                // weakest_sun .. strongest_sun

    bool operator==(const Sun&) const = default;
};

struct Light {
    std::optional<int> lights{};  // directions of the sky, fewest_lights .. most_lights; none: as many as suit the scene
    double sky = 1.0;             // 0 .. most_sky: the strength of the sky, and of the key light in it
    double key = 1.0;             // 0 .. most_key: how much brighter the sky is around the key light
    std::optional<Sun> sun{};

    bool operator==(const Light&) const = default;
};

}  // namespace sphereview

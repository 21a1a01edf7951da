// The light of a scene in the shading `studio`: a sky all round with a soft key light in it, and perhaps a sun.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace sphereview {

inline constexpr int fewest_lights = 16;
inline constexpr int most_lights = 1024;
inline constexpr double most_sky = 1.0;
inline constexpr double most_key = 1.0;
// A weaker sun's share of the light would be less than its rounding.
inline constexpr double weakest_sun = 0.001;
inline constexpr double strongest_sun = 4.0;

// Strengths of sun and sky together, if none is given: the brightest surfaces are about white, and shadows half as bright. A sun of
// strength 1 beside a full sky would turn most lit surfaces white.
inline constexpr double sky_beside_sun = 0.4;
inline constexpr double sun_beside_sky = 0.7;

// One hard light, infinitely far away.
struct Sun {
    glm::dvec3 direction{0.0, 1.0, 0.0};  // from the scene to the sun, of any length: finite and not zero
    std::optional<double> strength{};     // weakest_sun .. strongest_sun; none: sun_strength_of()

    bool operator==(const Sun&) const = default;
};

struct Light {
    std::optional<int> lights{};  // directions of the sky, fewest_lights .. most_lights; none: by the scene
    std::optional<double> sky{};  // 0 .. most_sky: the strength of the sky, and of the key light in it; none: sky_of()
    double key = 1.0;             // 0 .. most_key: how much brighter the sky is around the key light
    std::optional<Sun> sun{};
    // From the scene to the key light; none: by the camera. Set only for pictures around a scene; no file holds it.
    std::optional<glm::dvec3> toward_key{};

    bool operator==(const Light&) const = default;
};

// The strength of the sky; by default less beside a sun.
constexpr double sky_of(const Light& light) { return light.sky.value_or(light.sun ? sky_beside_sun : most_sky); }

// The strength of the sun, which must exist; by default less beside a sky of default strength.
constexpr double sun_strength_of(const Light& light) { return light.sun->strength.value_or(light.sky ? 1.0 : sun_beside_sky); }

}  // namespace sphereview

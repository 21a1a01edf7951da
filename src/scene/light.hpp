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
    // From the scene to the key light; none: by the camera, as everywhere but in pictures around a scene. No file holds it.
    std::optional<glm::dvec3> toward_key{};

    bool operator==(const Light&) const = default;
};

// Sun and sky that make a good picture together: the brightest surfaces are about as bright as white can be, and shadows half as
// bright. A sun of strength 1 beside a full sky would make white of most of what it shines on.
inline constexpr double sky_beside_sun = 0.4;
inline constexpr double sun_beside_sky = 0.7;

// The light with a sun that nobody has said more of than where it shines from. A sky as it comes makes room for its light.
constexpr Light with_sun(Light light, const glm::dvec3& direction) {
    if (light.sun) {
        light.sun->direction = direction;
    } else if (light.sky == most_sky) {
        light.sky = sky_beside_sun;
        light.sun = Sun{direction, sun_beside_sky};
    } else {
        light.sun = Sun{direction, 1.0};
    }
    return light;
}
// And without it again.
constexpr Light without_sun(Light light) {
    if (light.sun && light.sky == sky_beside_sun) light.sky = most_sky;
    light.sun.reset();
    return light;
}

}  // namespace sphereview

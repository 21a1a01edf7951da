// The lights of a picture: the sky's directions in the order in which they are added, and the sun. docs/light.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/camera.hpp"
#include "scene/light.hpp"

namespace sphereview {

// A sum of lights in whole numbers, so the order of the terms changes nothing. `light_one` is a light of strength 1.
struct LightVector {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;

    LightVector& operator+=(const LightVector& other) {
        x += other.x;
        y += other.y;
        z += other.z;
        return *this;
    }
    bool operator==(const LightVector&) const = default;
};

// No sum overflows: sky and key are less than 3.1 together, the sun at most 4.
inline constexpr double light_one = 0x1p28;

// The brightness that sky and key light, of strength 1 each, give a free surface that faces the key.
inline constexpr double sky_light = 0.62;
inline constexpr double key_light = 0.45;
// The direction to the key light, in the view's right, up and toward the eye; of any length.
inline constexpr glm::dvec3 key_in_view{-0.45, 0.75, 0.55};

// From the scene to the key light, of length 1: above left of the eye.
glm::dvec3 key_direction(const CameraAxes& axes);

// A light at infinity.
struct DirectedLight {
    glm::dvec3 direction;  // to the light, of any length: shadows are decided for these very numbers
    LightVector share;     // what the light adds where it shines
};

// The number of the sky's directions for a scene of so many spheres. Several samples a pixel have fewer each, because their sets
// differ.
int sky_lights(const Light& light, std::size_t spheres, int samples);

// How many turned sets there are: each point of a pixel has its own.
inline constexpr int turned_sets = 16;

// The lights of a set, the sun first, in an order whose beginnings are spread evenly, too. Lights that add nothing are left out.
// The directions are fixed to the scene; the key light is fixed to the camera, unless `light` gives its direction.
std::vector<DirectedLight> light_set(const Light& light, int lights, const Camera& camera, int set);

// The sets of a picture of so many spheres, one for each of a pixel's side x side points.
std::vector<std::vector<DirectedLight>> light_sets(const Light& light, std::size_t spheres, const Camera& camera, int side);

}  // namespace sphereview

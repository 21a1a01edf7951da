// The lights of a picture: the sky's directions in the order in which they are added, and the sun. docs/light.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "scene/camera.hpp"
#include "scene/light.hpp"

namespace sphereview {

// A sum of lights: whole numbers, so that the order of the sum changes nothing. `light_one` is a light of strength 1.
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

// No sum overflows: sky and key come to less than 3.1, the sun to 4.
inline constexpr double light_one = 0x1p28;

// How bright sky and key light make a free surface that faces the key, of strength 1 each.
inline constexpr double sky_light = 0.62;
inline constexpr double key_light = 0.45;
// To the key light, in the view's directions right, up and toward the eye; of any length.
inline constexpr glm::dvec3 key_in_view{-0.45, 0.75, 0.55};

// From the scene to the key light, of length 1: above left of the eye.
glm::dvec3 key_direction(const CameraAxes& axes);

// A light at infinity.
struct DirectedLight {
    glm::dvec3 direction;  // to the light, of any length: the very numbers that shadows are decided for
    LightVector share;     // what the light adds where it shines
};

// Directions of the sky for a scene of so many spheres: fewer for each of several points of a pixel, whose sets differ.
int sky_lights(const Light& light, std::size_t spheres, int samples);

// Each of the points of a pixel has a turned set of its own: so many.
inline constexpr int turned_sets = 16;

// Of a set, in an order whose beginnings are spread evenly, too; the sun comes first. Lights that add nothing are left out. The
// directions are fixed to the scene, the key light to the camera unless the light says where it is.
std::vector<DirectedLight> light_set(const Light& light, int lights, const Camera& camera, int set);

// The sets of a picture of so many spheres, one for each of the points, `side` along a side of a pixel.
std::vector<std::vector<DirectedLight>> light_sets(const Light& light, std::size_t spheres, const Camera& camera, int side);

}  // namespace sphereview

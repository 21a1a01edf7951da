// Whether values are the same bit for bit; with ==, -0 equals 0, and a file tells them apart.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

inline bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

inline bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

// What decides which pixels a sphere may take.
inline bool same_geometry(const Sphere& a, const Sphere& b) {
    return same_bits(a.center, b.center) && same_bits(a.radius, b.radius) && a.hidden == b.hidden;
}

inline bool same_bits(const Sphere& a, const Sphere& b) { return same_geometry(a, b) && a.color == b.color; }

inline bool same_bits(const Camera& a, const Camera& b) {
    return same_bits(a.eye, b.eye) && same_bits(a.center, b.center) && same_bits(a.right, b.right) && same_bits(a.up, b.up);
}

}  // namespace sphereview

// How a sphere stands in the lists of tiles.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "exact/candidates.hpp"

namespace sphereview {

// No hit of the sphere, a member of DrawnSpheres::center_radius, is nearer to the eye than this.
inline float nearest_distance(const glm::vec4& sphere) {
    constexpr double tolerance = 0x1p-21;  // of |x| + |y| + |z| + r, for the rounding to float of the input and of the result
    if (sphere.w == 0.0F) return 0.0F;     // the eye is on the surface, or nothing is known
    const glm::dvec3 center(sphere);
    const double radius = std::fabs(static_cast<double>(sphere.w));
    const double all = std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z) + radius;
    return static_cast<float>(std::max(0.0, std::fabs(glm::length(center) - radius) - tolerance * all));
}

// The key by which lists ascend: nearest first, equally near ones by index. Floats that are not negative are in the order of their
// bits.
inline std::uint64_t place_in_list(const Candidate& candidate) {
    static_assert(std::endian::native == std::endian::little && sizeof(Candidate) == sizeof(std::uint64_t));
    return std::bit_cast<std::uint64_t>(candidate);
}

}  // namespace sphereview

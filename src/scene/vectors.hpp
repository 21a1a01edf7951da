// Vector functions with a fixed order of sums, so that the bits are the same everywhere, and for vectors near the limits of
// doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "base/square_root.hpp"

namespace sphereview {

inline double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// -0 becomes 0.
inline glm::dvec3 without_negative_zero(const glm::dvec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

// The sum of the components' sizes.
inline double taxicab_length(const glm::dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

// The e with 2^(e-1) <= |value| < 2^e; 0 for 0. `value`: finite.
inline int exponent_of(double value) {
    int exponent = 0;
    std::frexp(value, &exponent);
    return exponent;
}

// v times 2^exponent.
inline glm::dvec3 times_two_to(const glm::dvec3& v, int exponent) {
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// The size of the largest component.
inline double largest_of(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// The length of a vector of any size: divides first, so that no square leaves the range of doubles.
inline double length_of(const glm::dvec3& v) {
    const double largest = largest_of(v);
    if (!(largest > 0.0)) return 0.0;
    const glm::dvec3 part = v / largest;
    return largest * square_root(dot(part, part));
}

// The vector with length 1; a zero vector stays. Divides first, so that no square leaves the range of doubles.
inline glm::dvec3 unit(glm::dvec3 v) {
    const double largest = largest_of(v);
    if (largest == 0.0) return v;
    v /= largest;
    return v / square_root(dot(v, v));
}

}  // namespace sphereview

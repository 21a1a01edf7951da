#include "panels/measures.hpp"

#include <cmath>
#include <numbers>

#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double degrees_of_radian = 180.0 / std::numbers::pi;

}  // namespace

double distance_of(const glm::dvec3& a, const glm::dvec3& b) { return length_of(b - a); }

std::optional<double> angle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 first = unit(a - b);
    const glm::dvec3 second = unit(c - b);
    if (first == glm::dvec3(0.0) || second == glm::dvec3(0.0)) return std::nullopt;
    // The arc tangent, which is right also for angles near 0 and 180.
    return std::atan2(length_of(cross(first, second)), dot(first, second)) * degrees_of_radian;
}

std::optional<double> dihedral_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                  bool left_handed) {
    const glm::dvec3 along = unit(c - b);
    const glm::dvec3 before = cross(unit(b - a), along);
    const glm::dvec3 after = cross(along, unit(d - c));
    constexpr double on_a_line = 1e-9;
    if (length_of(before) < on_a_line || length_of(after) < on_a_line) return std::nullopt;
    const double angle = std::atan2(dot(cross(before, after), along), dot(before, after)) * degrees_of_radian;
    return left_handed && angle < 180.0 ? -angle + 0.0 : angle;
}

}  // namespace sphereview

// Lengths and angles between points.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace sphereview {

double distance_of(const glm::dvec3& a, const glm::dvec3& b);

// Between the ways from `b` to `a` and to `c`, in degrees, 0 to 180; nothing where a way has no length.
std::optional<double> angle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

// Along the way from `b` to `c`: how far `d` is turned from `a`, in degrees, above -180 to 180; positive where that is clockwise
// for who looks from `b` to `c`, as chemists have it. In left-handed coordinates (`left_handed`) the same is seen. Nothing where
// three points lie on a line.
std::optional<double> dihedral_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d,
                                  bool left_handed);

}  // namespace sphereview

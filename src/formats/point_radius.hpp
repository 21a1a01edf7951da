// The radius of points without one in the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/sphere_data.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// A quarter of the median distance from a point to its nearest neighbour in another place, so that the points are seen apart; of a
// sample if there are many. The same double on every machine: +, -, *, / and square roots in a fixed order. Centres must be finite.
// Nothing if fewer than two places differ, or their distances are beyond a double.
std::optional<double> radius_of_points(const std::vector<Sphere>& points);

// If `options` give no radius: gives all spheres of `data`, whose file has none, this radius or DataOptions::radius_of_points, with
// a warning that begins with the file's `name`. Without such a radius the spheres keep theirs.
void use_radius_of_points(SphereData& data, const std::string& name, const DataOptions& options);

}  // namespace sphereview

// A radius for points of which a file says none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "formats/sphere_data.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// A quarter of the median distance from a point to its nearest neighbour in another place, so that the points lie apart and are
// seen; of a sample where there are many. The same double on every machine: +, -, *, / and square roots in a fixed order.
// Centres must be finite. Nothing where fewer than two places differ, or where their distances are beyond a double.
std::optional<double> radius_of_points(const std::vector<Sphere>& points);

// Where `options` give no radius: gives all spheres of `data`, of which the file says none, that radius, and says so in a warning,
// which begins with the file's `name`; or DataOptions::radius_of_points. Where there is none they keep theirs.
void use_radius_of_points(SphereData& data, const std::string& name, const DataOptions& options);

}  // namespace sphereview

// Spheres that equal an earlier one.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/sphere.hpp"

namespace sphereview {

// For each sphere 1 if it can never be seen: it is hidden, or an earlier one that is not has the same centre and radius
// (-0 equals 0, colours do not matter), and of equal hits the first is seen. With all cores.
std::vector<std::uint8_t> never_seen(const std::vector<Sphere>& spheres);

}  // namespace sphereview

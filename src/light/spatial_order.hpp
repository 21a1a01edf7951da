// An order in which spheres that are near each other come near each other: whatever is done for one sphere after the other, in
// tiles of any light's plane, then finds the tile in the processor's cache.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/drawn.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The indices of the drawn spheres, without gaps: cell by cell of a grid of 64 x 64 x 64 around all centres, the cells in Morton's
// order.
std::vector<std::uint32_t> spatial_order(const Scene& scene, const DrawnSpheres& drawn);

}  // namespace sphereview

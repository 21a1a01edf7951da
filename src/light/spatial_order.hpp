// An order in which spheres near each other in space follow each other. Work on one sphere after the other then finds the tiles of
// any light's plane in the processor's cache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/drawn.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A grid of 64 x 64 x 64 cells around all centres of drawn spheres.
class SpatialGrid {
public:
    static constexpr std::size_t cells = std::size_t{1} << 18;

    SpatialGrid(const Scene& scene, const DrawnSpheres& drawn);

    // The number of a centre's cell in Morton's order, below `cells`.
    std::uint32_t cell(const glm::dvec3& center) const;

private:
    glm::dvec3 low_{0.0};
    glm::dvec3 high_{0.0};
};

// The indices of the drawn spheres, without gaps, cell by cell.
std::vector<std::uint32_t> spatial_order(const Scene& scene, const DrawnSpheres& drawn, const SpatialGrid& grid);

}  // namespace sphereview

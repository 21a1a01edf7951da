// The spheres of each screen tile, nearest first.
#pragma once

#include <cstddef>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "scene/camera.hpp"
#include "tiles/pixel_range.hpp"
#include "tiles/tile_plan.hpp"

namespace sphereview {

// Memory for a drawn sphere and its lists while these are built; more if most spheres are large.
inline constexpr std::size_t bytes_to_draw_a_sphere = 90;

// The lists of a picture, built with all cores. Their sum is bounded: a sphere that covers many tiles goes to a level of larger
// ones. Throws RenderError when they are too long all the same: billions of spheres. The lists hold for the grid's traced pixels
// alone, because many small spheres lie between the rays of a coarse grid. `spare`: reserves memory for so many more candidates.
CandidateLists build_lists(const DrawnSpheres& spheres, const Camera& camera, const PixelGrid& grid, const TileCosts& costs,
                           std::size_t spare = 0);

}  // namespace sphereview

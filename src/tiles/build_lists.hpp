// The spheres of each screen tile, nearest first.
#pragma once

#include <cstddef>
#include <cstdint>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "scene/camera.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {

// A renderer's costs of tiles, by which the tiles of least cost are chosen. The picture does not depend on them.
struct TileCosts {
    int smallest_shift = 0;  // no tile's side is below 2^this pixels
    double candidate = 1.0;  // of listing one sphere in one tile
    double test = 1.0;       // of trying one candidate for one pixel
    // The lists of a scene hold about so many candidates. A sphere that covers more tiles than its equal part of the budget, and
    // more than 16, is listed in a level of larger tiles.
    std::int64_t shared_budget = 1 << 22;
};

// Memory for a drawn sphere and its lists while these are built; more if most spheres are large.
inline constexpr std::size_t bytes_to_draw_a_sphere = 90;

// The lists of a picture, built with all cores. Their sum is bounded: a sphere that covers many tiles goes to a level of larger
// ones. Throws RenderError when they are too long all the same: billions of spheres. The lists hold for the grid's traced pixels
// alone, because many small spheres lie between the rays of a coarse grid. `spare`: reserves memory for so many more candidates.
CandidateLists build_lists(const DrawnSpheres& spheres, const Camera& camera, const PixelGrid& grid, const TileCosts& costs,
                           std::size_t spare = 0);

}  // namespace sphereview

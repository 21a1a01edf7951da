// Visibility on the CPU: the readable reference, and the renderer where there is no GL.
#pragma once

#include <cstdint>
#include <span>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "exact/visible.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

// The CPU tries a sphere for a square of pixels at once, of this side (2^cpu_cell_shift). Its tiles must not be smaller.
inline constexpr int cpu_cell_shift = 3;
inline constexpr TileCosts cpu_tile_costs = {.smallest_shift = cpu_cell_shift, .candidate = 20.0, .test = 1.0};

// Traces with all cores. The spheres and lists passed in must outlive it.
class CpuRenderer {
public:
    CpuRenderer(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size);

    // Writes, row by row, what each pixel of the block shows (exact/visible.hpp), as indices among the drawn spheres.
    void trace(const Block& block, std::span<std::int32_t> visible) const;

private:
    void trace_cell(Pixel cell, const Block& block, std::int32_t* visible) const;

    const DrawnSpheres& spheres_;
    const CandidateLists& lists_;
    FloatView view_;
    PictureSize size_;
};

}  // namespace sphereview

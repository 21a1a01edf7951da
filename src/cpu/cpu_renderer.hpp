// Visibility on the CPU: the readable reference, and the renderer where there is no GL.
#pragma once

#include <cstdint>
#include <span>

#include "exact/drawn.hpp"
#include "exact/visible.hpp"

namespace sphereview {

// Traces with all cores. The spheres passed in must outlive it.
class CpuRenderer {
public:
    CpuRenderer(const DrawnSpheres& spheres, const Camera& camera, PictureSize size);

    // Writes, row by row, what each pixel of the block shows (exact/visible.hpp), as indices among the drawn spheres.
    void trace(const Block& block, std::span<std::int32_t> visible) const;

private:
    void trace_run(int x, int y, int count, std::int32_t* visible) const;

    const DrawnSpheres& spheres_;
    FloatView view_;
    PictureSize size_;
};

}  // namespace sphereview

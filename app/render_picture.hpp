// Scene -> Image, by whichever renderer is open.
#pragma once

#include "app/backend.hpp"
#include "base/progress.hpp"
#include "exact/resolve.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct PictureOptions {
    PictureSize size;
    Background background;
    bool certify = true;  // false: best guesses stay as they are
};

// Traces block by block, certifies and colours on the CPU; `counts` says how the pixels were decided. An OpenBackend without a GPU
// renderer stands for the CPU's. Throws RenderError when the GPU renderer cannot hold the scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, DecisionCounts& counts, Progress& progress);

}  // namespace sphereview

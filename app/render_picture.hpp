// Scene -> Image, by whichever renderer is open.
#pragma once

#include "app/backend.hpp"
#include "base/progress.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Traces block by block and colours on the CPU. An OpenBackend without a GPU renderer stands for the CPU's.
// Throws RenderError when the GPU renderer cannot hold the scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const Background& background, PictureSize size,
                     Timings& timings, Progress& progress);

}  // namespace sphereview

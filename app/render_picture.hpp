// Scene -> Image, by whichever renderer is open.
#pragma once

#include <string>
#include <vector>
#include "app/backend.hpp"
#include "base/progress.hpp"
#include "exact/resolve.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

struct PictureOptions {
    PictureSize size;
    Background background;
    bool certify = true;  // false: best guesses stay as they are
    Shading shading = Shading::flat;
};

// How a picture came about.
struct PictureFacts {
    DecisionCounts decisions;
    std::string spheres_in;       // where the renderer kept them
    std::vector<int> tile_sides;  // of the levels that are not empty, in pixels, the coarsest first
    std::size_t candidates = 0;   // in all lists
    std::size_t longest_list = 0;
};

// Traces block by block, certifies and colours on the CPU. An OpenBackend without a GPU
// renderer stands for the CPU's. Throws TooLarge when the GPU renderer cannot hold the scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, PictureFacts& facts, Progress& progress);

}  // namespace sphereview

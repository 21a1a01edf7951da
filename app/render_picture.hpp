// Scene -> Image, by whichever renderer is open.
#pragma once

#include <string>
#include <vector>
#include "app/backend.hpp"
#include "base/progress.hpp"
#include "exact/resolve.hpp"
#include "image/image.hpp"
#include "scene/samples.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

struct PictureOptions {
    PictureSize size;  // sides at most longest_side(samples)
    Background background;
    bool certify = true;  // false: best guesses stay as they are
    int samples = 1;      // points a pixel: one of sample_counts
    Shading shading = Shading::flat;
};

// The widest and highest a picture with so many samples may be: that of all points is no longer than any picture.
constexpr int longest_side(int samples) { return static_cast<int>(most_pixels / sample_side(samples)); }

// How a picture came about.
struct PictureFacts {
    DecisionCounts decisions;     // of the points of all pixels
    std::string spheres_in;       // where the renderer kept them
    std::vector<int> tile_sides;  // of the levels that are not empty, in pixels, the coarsest first
    std::size_t candidates = 0;   // in all lists
    std::size_t longest_list = 0;
};

// Traces block by block, certifies, colours and averages on the CPU. An OpenBackend without a GPU
// renderer stands for the CPU's. Throws TooLarge when the GPU renderer cannot hold the scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, PictureFacts& facts, Progress& progress);

}  // namespace sphereview

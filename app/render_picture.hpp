// Scene -> Image, by whichever renderer is open.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/backend.hpp"
#include "app/picture_marks.hpp"
#include "exact/resolve.hpp"
#include "image/image.hpp"
#include "light/kept_light.hpp"
#include "scene/camera.hpp"
#include "scene/light.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

struct PictureOptions {
    Camera camera;
    PictureSize size;  // sides at most longest_side(samples)
    Background background;
    bool certify = true;  // false: best guesses stay as they are
    int samples = 1;      // points a pixel: one of sample_counts
    Shading shading = Shading::flat;
    Light light{};  // in the shading `studio`
    PictureMarks marks{};

    bool operator==(const PictureOptions&) const = default;
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
    bool shows_sphere = false;  // anywhere
};

// What a picture looks like on the way, for whoever shows it.
struct Drafts {
    Image under;                      // an earlier picture of the same size, in place of what is not finished; or empty
    std::function<void(Image)> show;  // is called now and then
};

// Traces block by block, certifies, colours and averages on the CPU, and draws the marks. An OpenBackend without a GPU renderer
// stands for the CPU's. `drawn` is as the options' camera sees it. Calls progress() with how much is done, 0..1, and shows drafts
// in the shading `studio`, in which `kept` is given which lights shine where. Throws TooLarge when the GPU renderer cannot hold the
// scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, PictureFacts& facts, const std::function<void(double)>& progress,
                     const Drafts* drafts = nullptr, KeptLight* kept = nullptr);

// The same bytes of the picture of which `kept` was kept, but for the strengths of its lights. Nothing where not all was kept, or
// a light is where none was.
std::optional<Image> relit_picture(const Scene& scene, const PictureOptions& options, const KeptLight& kept);

// Calls render(opened); where the GPU renderer of `opened` cannot hold the scene and nobody asked for that one by name, calls
// render() again with the CPU's, whose passed_over then says why. Throws RenderError where one that was asked for cannot hold the
// scene.
Image render_by_what_holds_it(OpenBackend& opened, Backend asked_for, const std::function<Image(OpenBackend&)>& render);

}  // namespace sphereview

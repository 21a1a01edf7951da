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

// The largest side of a picture with so many samples: the picture of all points has the usual bound.
constexpr int longest_side(int samples) { return static_cast<int>(most_pixels / sample_side(samples)); }

// Facts about the making of a picture.
struct PictureFacts {
    DecisionCounts decisions;     // for the points of all pixels
    std::string spheres_in;       // where the renderer keeps the spheres
    std::vector<int> tile_sides;  // of the levels that are not empty, in pixels, the coarsest first
    std::size_t candidates = 0;   // in all lists
    std::size_t longest_list = 0;
    bool shows_sphere = false;  // in any pixel
};

// Drafts of a picture while it is made.
struct Drafts {
    Image under;                      // an earlier picture of the same size, shown where nothing is finished; or empty
    std::function<void(Image)> show;  // called now and then
};

// Traces block by block, certifies, colours and averages on the CPU, and draws the marks. `drawn`: by the options' camera. Calls
// progress() with the finished part, 0..1. In the shading `studio` shows drafts, and `kept` gets which lights shine where. Throws
// TooLarge when the GPU renderer cannot hold the scene.
Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, PictureFacts& facts, const std::function<void(double)>& progress,
                     const Drafts* drafts = nullptr, KeptLight* kept = nullptr);

// The picture, byte for byte, made from the `kept` light of a picture that differs only in strengths of lights. Nothing if `kept`
// is not complete or lacks a light.
std::optional<Image> relit_picture(const Scene& scene, const PictureOptions& options, const KeptLight& kept);

// Calls render(opened). If the GPU renderer cannot hold the scene, calls render() again with the CPU renderer, whose passed_over
// then says why; throws RenderError instead if `asked_for` names the backend.
Image render_by_what_holds_it(OpenBackend& opened, Backend asked_for, const std::function<Image(OpenBackend&)>& render);

}  // namespace sphereview

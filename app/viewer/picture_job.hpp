// Pictures as `render` writes them, made beside the window's loop: what the window shows at rest, and PNG files. A job calls
// render_picture() with the CPU renderer: the picture is the same as the GPU's, and the window's context keeps what it holds. So
// whatever is promised of exports holds for the window at rest. The next input cancels its job.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "app/render_picture.hpp"
#include "base/background_job.hpp"
#include "image/image.hpp"
#include "viewer/made_beside.hpp"

namespace sphereview {

class Document;
struct ViewerState;

// The spheres as they were, for other threads.
struct SceneSnapshot {
    std::uint64_t revision = 0;  // of the document; 0: none
    std::shared_ptr<const Scene> scene;
};

// A copy of the spheres, unless there is one: 40 MB and some 10 ms a million.
std::shared_ptr<const Scene> scene_snapshot(ViewerState& state);

// The best that there is yet of a picture: shown until all of it is made. Null before there is anything.
using Preview = HandedOver<std::shared_ptr<const Image>>;

// Which lights shine where in the window's picture: where only their strengths change it is there again at once. Both threads use
// it.
class KeptLights {
public:
    KeptLights(std::uint64_t revision, PictureOptions options) : revision_(revision), options_(std::move(options)) {}

    // Whether they are of this picture, but for the strengths of the lights. The revision becomes the present one.
    bool are_of(const Document& document, const PictureOptions& options);

    // Of the draft and of the picture itself: null until they are decided, and where they take too much memory.
    HandedOver<std::shared_ptr<const KeptLight>> draft{};
    HandedOver<std::shared_ptr<const KeptLight>> picture{};

private:
    std::uint64_t revision_;  // of the document
    PictureOptions options_;
};

// The picture that the window shows at rest.
struct RestPicture {
    std::uint64_t revision;  // of the document that it is of
    PictureOptions options;
    std::shared_ptr<Image> image;  // empty until the job has ended, and if it failed
    std::shared_ptr<Preview> preview;
    BackgroundJob job;
    std::shared_ptr<const Image> before{};  // of other strengths of the lights: shown until there is a better one
    std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();

    bool is_made() const { return job.ended() && image->width() > 0; }
    // The best that there is before it is made; null before there is anything.
    std::shared_ptr<const Image> draft() const {
        const auto better = preview->get();
        return better ? better : before;
    }
};

// The very function that `render` calls; `progress` is told how much is done, 0..1, and may throw.
Image render_beside(const Scene& scene, const PictureOptions& options, const std::function<void(double)>& progress,
                    const Drafts* drafts = nullptr, KeptLight* kept = nullptr);
// `control` cancels it and is told how far it is.
Image render_beside(const Scene& scene, const PictureOptions& options, WorkControl& control, const Drafts* drafts = nullptr,
                    KeptLight* kept = nullptr);

// Forgets the window's rest picture, and cancels its job, if the window has come to show something else. Where that differs in the
// strengths of lights alone, and it is kept which of them shine where, begins to make it anew; until there is something of that,
// what there was stays. Returns whether what is left is finished: then the window shows that.
bool rest_picture_is_shown(ViewerState& state);

// Begins to make it, if it is not there, nor any other picture being made. To be called when the window rests. `seen` returns what
// the window's pixels show, as LivePicture::seen_numbers() does.
void make_rest_picture(ViewerState& state, const std::function<std::vector<std::int32_t>()>& seen);

// F12: writes a PNG to the next free name beside the scene, or in the Pictures folder. Does nothing while another export is on its
// way.
void export_now(ViewerState& state);

// File > Export: asks for name and size, and before it overwrites.
void ask_for_export(ViewerState& state);

// What is asked for instead of the picture: one sample a pixel, and no more lights than a draft needs.
PictureOptions draft_options(const Scene& scene, PictureOptions options);

// A lit picture before there is an exact one: lights the picture whose pixels show these spheres: numbers or visible_background,
// doubtful guesses marked, row by row. Calls show() as light is added; `kept` is given which lights shine where.
Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept = nullptr);

}  // namespace sphereview

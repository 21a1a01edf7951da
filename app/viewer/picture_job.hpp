// Makes pictures as `render` does, beside the window's loop: the window's picture at rest, and PNG files. A job calls
// render_picture() with the CPU renderer, whose picture is the GPU's, so the window's GL context is left alone. The next input
// cancels the job of the picture at rest.
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

// A copy of the scene for other threads.
struct SceneSnapshot {
    std::uint64_t revision = 0;  // of the document; 0: none
    std::shared_ptr<const Scene> scene;
};

// The copy of the present scene, made when needed: 40 MB and some 10 ms a million spheres.
std::shared_ptr<const Scene> scene_snapshot(ViewerState& state);

// The best draft of a picture so far; null before the first.
using Preview = HandedOver<std::shared_ptr<const Image>>;

// The lights that shine on each point of the window's picture. When only their strengths change, the picture is made anew at once.
// Both threads use this.
class KeptLights {
public:
    KeptLights(std::uint64_t revision, PictureOptions options) : revision_(revision), options_(std::move(options)) {}

    // Whether the kept lights are of this picture, apart from strengths of lights. Then takes over the present revision.
    bool are_of(const Document& document, const PictureOptions& options);

    // The draft's and the picture's: null until decided, and if they need too much memory.
    HandedOver<std::shared_ptr<const KeptLight>> draft{};
    HandedOver<std::shared_ptr<const KeptLight>> picture{};

private:
    std::uint64_t revision_;  // of the document
    PictureOptions options_;
};

// The picture that the window shows at rest.
struct RestPicture {
    std::uint64_t revision;  // of the document
    PictureOptions options;
    std::shared_ptr<Image> image;  // empty until the job has ended, or if it failed
    std::shared_ptr<Preview> preview;
    BackgroundJob job;
    std::shared_ptr<const Image> before{};  // with former strengths of lights, shown until there is a better one
    std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();

    bool is_made() const { return job.ended() && image->width() > 0; }
    // The best draft; null before the first.
    std::shared_ptr<const Image> draft() const {
        const auto better = preview->get();
        return better ? better : before;
    }
};

// Calls render_picture() with the CPU renderer. `progress` gets the finished part, 0..1, and may throw.
Image render_beside(const Scene& scene, const PictureOptions& options, const std::function<void(double)>& progress,
                    const Drafts* drafts = nullptr, KeptLight* kept = nullptr);
// The same; `control` cancels the work and gets its progress.
Image render_beside(const Scene& scene, const PictureOptions& options, WorkControl& control, const Drafts* drafts = nullptr,
                    KeptLight* kept = nullptr);

// Cancels and forgets the rest picture if the window has come to show something else. If only strengths of lights differ and the
// lights are kept, makes the new picture from these and shows the former one meanwhile. Returns whether a finished picture is left
// to show.
bool rest_picture_is_shown(ViewerState& state);

// Begins the rest picture, unless it exists or another picture is being made. Call when the window rests. `seen` returns the
// window's pixels as LivePicture::seen_numbers() does.
void make_rest_picture(ViewerState& state, const std::function<std::vector<std::int32_t>()>& seen);

// F12: writes a PNG to the next free name beside the scene, or in the Pictures folder. Does nothing during another export.
void export_now(ViewerState& state);

// File > Export: asks for name and size; asks before it overwrites.
void ask_for_export(ViewerState& state);

// The options of the draft: one sample a pixel, and fewer lights.
PictureOptions draft_options(const Scene& scene, PictureOptions options);

// A quick lit picture of what the window shows already, before the exact one. Lights the picture whose pixels show the spheres
// `seen`: numbers or visible_background, doubtful guesses marked, row by row. Calls show() as light is added. `kept` gets which
// lights shine where.
Image lit_draft(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept = nullptr);

}  // namespace sphereview

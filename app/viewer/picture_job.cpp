#include "viewer/picture_job.hpp"

#include <algorithm>
#include <utility>

#include "app/failure.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "image/png.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// Whether all that a picture shows of the document's spheres is still as it was then; `revision` becomes the present one.
bool same_spheres(const Document& document, std::uint64_t& revision) {
    const ChangesSince changes = document.changes_since(revision);
    if (changes.order || !changes.spheres.empty()) return false;
    revision = document.revision();
    return true;
}

// A copy of the spheres, unless there is one: 40 MB and some 10 ms a million.
std::shared_ptr<const Scene> snapshot(ViewerState& state) {
    SceneSnapshot& kept = state.snapshot;
    if (!kept.scene || !same_spheres(state.document, kept.revision)) {
        Scene scene;
        scene.spheres = state.scene().spheres;
        kept = {state.document.revision(), std::make_shared<const Scene>(std::move(scene))};
    }
    return kept.scene;
}

// The very function that `render` calls. The CPU's renderer: the picture is the same on all, and the window's thread keeps its
// context.
Image render_beside(const Scene& scene, const PictureOptions& options, WorkControl& control) {
    constexpr double parts = 1000.0;
    control.total = static_cast<std::uint64_t>(parts);
    OpenBackend cpu;
    Timings timings;
    PictureFacts facts;
    return render_picture(cpu, scene, drawn_spheres(scene, options.camera), options, timings, facts, [&](double done) {
        control.check();
        control.done = static_cast<std::uint64_t>(parts * done);
    });
}

}  // namespace

PictureOptions picture_options(const ViewerState& state, PictureSize size) {
    return {state.camera, size, state.shown_background(), true, state.settings.samples, state.settings.shading};
}

bool rest_picture_is_shown(ViewerState& state) {
    if (!state.rest_picture) return false;
    RestPicture& picture = *state.rest_picture;
    const bool same = same_spheres(state.document, picture.revision);
    if (!same || picture.options != picture_options(state, state.picture_size)) state.rest_picture.reset();
    if (!same) state.snapshot = {};
    return state.rest_picture && picture.is_made();
}

void make_rest_picture(ViewerState& state) {
    // Shaders of a folder are there to be looked at; and one picture at a time is made.
    if (state.rest_picture || state.exporting || !state.options.shader_folder.empty()) return;
    const PictureOptions options = picture_options(state, state.picture_size);
    auto image = std::make_shared<Image>();
    BackgroundJob job(
        [image, options, scene = snapshot(state)](WorkControl& control) { *image = render_beside(*scene, options, control); });
    state.rest_picture.emplace(RestPicture{state.document.revision(), options, std::move(image), std::move(job)});
}

void start_export(ViewerState& state, const std::string& path, PictureSize size, std::function<void(const std::string& why)> fail) {
    const PictureOptions options = picture_options(state, size);
    try {
        if (std::max(size.width, size.height) > longest_side(options.samples)) {
            throw RenderError("a picture with " + std::to_string(options.samples) + " samples a pixel can be at most " +
                              in_groups(static_cast<std::uint64_t>(longest_side(options.samples))) + " pixels wide and high");
        }
        check_output(path);
    } catch (...) {
        return fail(describe_current_exception().message);
    }
    std::shared_ptr<const Image> made;
    if (rest_picture_is_shown(state) && state.rest_picture->options == options) made = state.rest_picture->image;
    auto png = std::make_shared<std::string>();
    BackgroundJob job([png, made, options, scene = made ? nullptr : snapshot(state)](WorkControl& control) {
        *png = made ? encode_png(*made) : encode_png(render_beside(*scene, options, control));
    });
    state.exporting.emplace(Exporting{path, options, std::move(png), std::move(job), std::move(fail)});
}

bool finish_export(ViewerState& state) {
    if (!state.exporting || !state.exporting->job.ended()) return false;
    const Exporting ended = std::move(*state.exporting);
    state.exporting.reset();
    try {
        ended.job.rethrow();
        // Here, so that what is cancelled before leaves nothing.
        write_output(ended.path, *ended.png);
    } catch (...) {
        ended.fail(describe_current_exception().message);
        return true;
    }
    const auto& [width, height] = ended.options.size;
    const int samples = ended.options.samples;
    announce(state, "Exported " + ended.path + " (" + std::to_string(width) + " x " + std::to_string(height) +
                        (samples > 1 ? ", " + std::to_string(samples) + " samples a pixel)" : ")"));
    ended.then();
    return true;
}

}  // namespace sphereview

#include "viewer/picture_job.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include "app/failure.hpp"
#include "base/error.hpp"
#include "base/gunzip.hpp"
#include "base/memory.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "exact/resolve.hpp"
#include "image/png.hpp"
#include "light/hit_places.hpp"
#include "light/lighting.hpp"
#include "shade/picture_shader.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/view_marks.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

// Lists for each light are worth their time for many points, which take some 100 bytes each.
constexpr int most_points = 1 << 20;

// The spheres that may be tried, all together, to decide pixels of which there is no guess: a fraction of a second.
constexpr std::size_t most_tried = 10'000'000;

// What the window's picture shows, where its guesses are hits: else nobody can say where the light falls. Such pixels are at the
// edge of a sphere and see another one behind it, or the background; as long as there is time they are decided.
class Believed {
public:
    Believed(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size)
        : scene_(scene), drawn_(drawn), places_(camera, size), resolver_(scene, drawn, camera, size, nullptr) {}

    std::int32_t operator()(Pixel pixel, std::int32_t seen) {
        if (!is_doubtful(seen)) return seen;
        const std::int32_t guess = doubtful(seen);
        if (guess < 0) return visible_background;
        if (is_hit(pixel, guess)) return guess;
        tried_ += drawn_.size();
        if (tried_ > most_tried) return visible_background;
        DecisionLevel level{};
        return resolver_.resolve(pixel, level);
    }

private:
    bool is_hit(Pixel pixel, std::int32_t number) const {
        const auto index = drawn_.index_of(static_cast<std::uint32_t>(number));
        const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(number)];
        return index && std::isfinite(places_.at(places_.ray(pixel), sphere, drawn_.side(*index)).error);
    }

    const Scene& scene_;
    const DrawnSpheres& drawn_;
    HitPlaces places_;
    Resolver resolver_;
    std::size_t tried_ = 0;
};

int rows_at_once(PictureSize size) { return std::clamp(most_points / size.width, 1, size.height); }

}  // namespace

PictureOptions draft_options(const Scene& scene, PictureOptions options) {
    // Light by light where all is lit at once; a larger picture is lit part by part.
    const bool grows = rows_at_once(options.size) == options.size.height;
    const bool finishes = options.samples > 1;  // nobody sees it with more lights
    options.light.lights = grows && finishes ? sky_lights(options.light, scene.spheres.size(), options.samples) : fewest_lights;
    options.samples = 1;
    return options;
}

Image lit_draft(const Scene& scene, const PictureOptions& picture_options, std::span<const std::int32_t> seen,
                const std::function<void(Image)>& show, KeptLight* kept) {
    const PictureOptions options = draft_options(scene, picture_options);
    const auto& [width, height] = options.size;
    const int rows = rows_at_once(options.size);
    const bool grows = rows == height;

    const DrawnSpheres drawn = drawn_spheres(scene, options.camera);
    Believed believed(scene, drawn, options.camera, options.size);
    const Lighting lighting(scene, drawn, options.camera, options.size, 1, options.light);
    if (kept != nullptr) kept->begin(lighting.sets(), 1);
    const PictureShader shader(scene, options.camera, options.size, Shading::studio, options.background);
    Image picture = make_picture(options.size, options.background);
    for (int y = 0; y < height; y += rows) {
        const Block block{0, y, width, std::min(rows, height - y)};
        const auto begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        std::vector<std::int32_t> visible(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
        for (std::size_t i = 0; i < visible.size(); ++i) {
            const auto place = static_cast<int>(i);
            visible[i] = believed({place % width, y + place / width}, seen[begin + i]);
        }
        // Few lights have hard shadows: the light that is missing counts as that of a free sky, as in the picture that moved.
        const auto show_some = [&](std::span<const LightVector> some, double missing) {
            shader.shade(block, visible, picture, {}, some, {options.light, missing});
            show(picture.copy());
        };
        const LightPreviews previews{.show = show_some, .as_bright = false};
        shader.shade(block, visible, picture, {}, lighting.light(block, visible, nullptr, grows ? &previews : nullptr, kept));
    }
    if (kept != nullptr) kept->finish();
    show(picture.copy());
    return picture;
}

namespace fs = std::filesystem;

namespace {

// Whether all that a picture shows of the document's spheres is still as it was then; `revision` becomes the present one.
bool same_spheres(const Document& document, std::uint64_t& revision) {
    const ChangesSince changes = document.changes_since(revision);
    if (changes.order || !changes.spheres.empty()) return false;
    revision = document.revision();
    return true;
}

// Kept lights may take this part of the available memory.
constexpr std::uint64_t part_for_lights = 8;
constexpr std::uint64_t most_for_lights = std::uint64_t{512} << 20;

std::size_t bytes_for_lights() {
    const std::uint64_t part = available_memory().value_or(part_for_lights * most_for_lights) / part_for_lights;
    return static_cast<std::size_t>(std::min(part, most_for_lights));
}

// Coarse, then fine: where light takes time, the picture grows under the eyes of whoever waits for it. `seen` is what the window
// shows. Of what is kept nothing is decided anew, and the rest is added.
Image render_growing(const Scene& scene, const PictureOptions& options, std::span<const std::int32_t> seen, WorkControl& control,
                     Preview& preview, KeptLights& kept) {
    if (!is_lit(options.shading)) return render_beside(scene, options, control);
    Drafts drafts{.under = {}, .show = [&](Image image) { preview.set(std::make_shared<const Image>(std::move(image))); }};
    const auto kept_draft = kept.draft.get();
    const auto kept_picture = kept.picture.get();
    std::optional<Image> relit_draft;
    if (kept_draft) relit_draft = relit_picture(scene, draft_options(scene, options), *kept_draft);
    if (relit_draft) {
        drafts.show(relit_draft->copy());
        drafts.under = std::move(*relit_draft);
    }
    if (kept_picture) {
        if (auto picture = relit_picture(scene, options, *kept_picture)) return std::move(*picture);
    }
    kept.picture.set(nullptr);
    if (!relit_draft) kept.draft.set(nullptr);
    const auto found = std::make_shared<KeptLight>(bytes_for_lights());
    if (!relit_draft && !seen.empty()) {
        const bool differs = options.samples > 1;  // else the picture itself is as soon there
        drafts.under = lit_draft(scene, options, seen, drafts.show, differs ? found.get() : nullptr);
        if (found->is_complete()) kept.draft.set(std::make_shared<const KeptLight>(std::move(*found)));
    }
    *found = KeptLight(bytes_for_lights());
    Image image = render_beside(scene, options, control, &drafts, found.get());
    if (found->is_complete()) kept.picture.set(found);
    return image;
}

// What `render` would be asked for the picture in the window, or for one of another size.
PictureOptions picture_options(const ViewerState& state, PictureSize size) {
    return {state.camera,       size, state.shown_background(), true, state.settings.samples, state.settings.shading,
            state.shown_light()};
}

// NAME.png beside the scene, or in the Pictures folder.
std::string usual_name(const ViewerState& state) {
    const fs::path folder = state.path.empty() ? pictures_folder() : path_from(state.path).parent_path();
    const std::string stem = state.path.empty() ? "untitled" : text_from(path_from(without_gzip_ending(state.path)).stem());
    return text_from(folder / path_from(stem + ".png"));
}

// NAME.png, NAME-1.png, NAME-2.png, ...: the first that is not there.
std::string next_free_name(const std::string& usual) {
    const fs::path first = path_from(usual);
    std::error_code error;
    fs::path name = first;
    for (int i = 1; fs::exists(fs::symlink_status(name, error)); ++i) {
        name = first;
        name.replace_filename(path_from(text_from(first.stem()) + "-" + std::to_string(i) + ".png"));
    }
    return text_from(name);
}

enum class Naming { as_said, next_free };

// Begins to write a file; none may be on its way. `fail` is called with what went wrong, now or later. The job alone asks for
// files: a FIFO that nobody reads, or a disk that hangs, holds up nobody else.
void start_export(ViewerState& state, const std::string& path, Naming naming, PictureSize size,
                  std::function<void(const std::string& why)> fail) {
    PictureOptions options = picture_options(state, size);
    options.marks = exported_marks(state);
    const auto written = std::make_shared<HandedOver<std::string>>(naming == Naming::as_said ? path : "");
    const auto done = [&state, written, options] {
        const auto& [width, height] = options.size;
        announce(state, "Exported " + on_one_line(written->get()) + " (" + std::to_string(width) + " x " + std::to_string(height) +
                            (options.samples > 1 ? ", " + std::to_string(options.samples) + " samples a pixel)" : ")"));
    };
    try {
        if (std::max(size.width, size.height) > longest_side(options.samples)) {
            throw RenderError("a picture with " + std::to_string(options.samples) + " samples a pixel can be at most " +
                              in_groups(static_cast<std::uint64_t>(longest_side(options.samples))) + " pixels wide and high");
        }
        std::shared_ptr<const Image> made;
        if (rest_picture_is_shown(state) && state.rest_picture->options == options) made = state.rest_picture->image;
        BackgroundJob job(
            [written, usual = path, made, options, scene = made ? nullptr : scene_snapshot(state)](WorkControl& control) {
                if (written->get().empty()) written->set(next_free_name(usual));
                const std::string name = written->get();
                check_output(name);
                const std::string png = made ? encode_png(*made) : encode_png(render_beside(*scene, options, control));
                control.begin_to_write();
                write_output(name, png);
            });
        state.exporting.emplace(Work{.path = path, .job = std::move(job), .done = done, .fail = fail, .found_path = written});
    } catch (...) {
        fail(describe_current_exception().message);
    }
}

void ask_for_export(ViewerState& state, const std::string& first, const std::string& fault) {
    FileBrowser form = saving_dialog(state, "Export picture", first, fault);
    form.kinds = {{"PNG", {".png"}}};
    form.only_kinds = true;
    form.size = PictureSize{state.settings.export_width, state.settings.export_height};
    form.view = state.picture_size;
    const std::string marks = shown_marks(state);
    if (!marks.empty()) form.marks = std::make_shared<MarksChoice>(MarksChoice{marks, state.settings.marks_exported});
    form.accept = [&state, marks = form.marks](const std::string& path, PictureSize size) {
        choose_size(state, &ViewerSettings::export_width, &ViewerSettings::export_height, size);
        if (marks) state.settings.marks_exported = marks->drawn;
        const auto ask_again = [&state, path](const std::string& why) { ask_for_export(state, path, why); };
        if (state.exporting) return ask_again(state.exporting->shown_path() + " is not exported yet");
        try {
            start_export(state, png_name(path), Naming::as_said, size, ask_again);
        } catch (const InputError& error) {
            ask_again(error.what());
        }
    };
    state.dialogs.push_back(std::move(form));
}

}  // namespace

Image render_beside(const Scene& scene, const PictureOptions& options, const std::function<void(double)>& progress,
                    const Drafts* drafts, KeptLight* kept) {
    OpenBackend cpu;
    Timings timings;
    PictureFacts facts;
    return render_picture(cpu, scene, drawn_spheres(scene, options.camera), options, timings, facts, progress, drafts, kept);
}

Image render_beside(const Scene& scene, const PictureOptions& options, WorkControl& control, const Drafts* drafts,
                    KeptLight* kept) {
    constexpr double parts = 1000.0;
    control.total = static_cast<std::uint64_t>(parts);
    const std::function<void(double)> progress = [&control](double done) {
        control.check();
        control.done = static_cast<std::uint64_t>(parts * done);
    };
    return render_beside(scene, options, progress, drafts, kept);
}

std::shared_ptr<const Scene> scene_snapshot(ViewerState& state) {
    SceneSnapshot& kept = state.snapshot;
    if (!kept.scene || !same_spheres(state.document, kept.revision)) {
        Scene scene;
        scene.spheres = state.scene().spheres;
        kept = {state.document.revision(), std::make_shared<const Scene>(std::move(scene))};
    }
    return kept.scene;
}

bool KeptLights::are_of(const Document& document, const PictureOptions& options) {
    if (!same_spheres(document, revision_)) return false;
    const Light& kept = options_.light;
    if (sky_of(kept) == 0.0 && sky_of(options.light) > 0.0) return false;  // nobody asked where the sky shines
    PictureOptions otherwise = options;
    otherwise.light.sky = kept.sky;
    otherwise.light.key = kept.key;
    if (!otherwise.light.sun) {
        otherwise.light.sun = kept.sun;
    } else if (kept.sun) {
        otherwise.light.sun->strength = kept.sun->strength;
    }
    return otherwise == options_;
}

namespace {

// Begins to make the window's picture. `before`: what to show until there is something of it.
void begin_rest_picture(ViewerState& state, const std::function<std::vector<std::int32_t>()>& seen,
                        std::shared_ptr<const Image> before) {
    const PictureOptions options = picture_options(state, state.picture_size);
    std::shared_ptr<const Scene> scene;
    try {
        scene = scene_snapshot(state);
    } catch (const std::bad_alloc&) {
        return;  // the live picture stays
    }
    auto image = std::make_shared<Image>();
    auto preview = std::make_shared<Preview>();
    const bool grows = is_lit(options.shading);
    if (!state.kept_lights || !state.kept_lights->are_of(state.document, options)) {
        state.kept_lights = std::make_shared<KeptLights>(state.document.revision(), options);
    }
    const auto kept = state.kept_lights;
    auto numbers = grows && !kept->draft.get() ? seen() : std::vector<std::int32_t>{};
    BackgroundJob job([image, preview, options, kept, numbers = std::move(numbers), scene](WorkControl& control) {
        *image = render_growing(*scene, options, numbers, control, *preview, *kept);
    });
    state.rest_picture.emplace(
        RestPicture{state.document.revision(), options, std::move(image), std::move(preview), std::move(job), std::move(before)});
}

}  // namespace

bool rest_picture_is_shown(ViewerState& state) {
    if (!state.rest_picture) return false;
    RestPicture& picture = *state.rest_picture;
    const PictureOptions options = picture_options(state, state.picture_size);
    const bool same = same_spheres(state.document, picture.revision);
    if (same && picture.options == options) return picture.is_made();
    const auto& kept = state.kept_lights;
    const bool relit =
        kept && (kept->draft.get() || kept->picture.get()) && is_lit(options.shading) && kept->are_of(state.document, options);
    if (!same) state.snapshot = {};
    if (!relit) {
        state.rest_picture.reset();
        if (kept && !kept->are_of(state.document, options)) state.kept_lights.reset();
        return false;
    }
    // Whoever drags a slider sees how the light changes: what is on its way is shown before the next is begun.
    const auto shown = picture.is_made() ? picture.image : picture.draft();
    if (!picture.job.ended() && shown == picture.before) return false;
    if (state.exporting) {
        state.rest_picture.reset();
        return false;
    }
    begin_rest_picture(
        state, [] { return std::vector<std::int32_t>{}; }, shown);
    return false;
}

void make_rest_picture(ViewerState& state, const std::function<std::vector<std::int32_t>()>& seen) {
    // Shaders of a folder are there to be looked at; and one picture at a time is made.
    if (state.rest_picture || state.exporting || !state.options.shader_folder.empty()) return;
    begin_rest_picture(state, seen, nullptr);
}

void export_now(ViewerState& state) {
    if (state.exporting) return;
    start_export(state, usual_name(state), Naming::next_free, {state.settings.export_width, state.settings.export_height},
                 [&state](const std::string& why) { report_error(state, "The picture cannot be exported", why); });
}

void ask_for_export(ViewerState& state) { ask_for_export(state, next_free_name(usual_name(state)), ""); }

}  // namespace sphereview

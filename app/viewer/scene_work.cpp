#include "viewer/scene_work.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "app/failure.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/text.hpp"
#include "formats/frame_reader.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t bytes_at_once = std::uintmax_t{1} << 20;
constexpr std::size_t spheres_at_once = 10'000;
constexpr std::chrono::milliseconds unnoticed{20};  // a redraw can wait so long

// The wanted frame, or the last where the file has fewer. `options` have a control. Throws as load_scene() does.
LoadedScene load_frame_or_last(const std::string& path, LoadOptions options) {
    try {
        return load_scene(path, options);
    } catch (const InputError&) {
        std::error_code error;
        if (options.data.frame == 0 || !fs::is_regular_file(path_from(path), error)) throw;
        FrameReader reader(path, options.data);
        reader.watch([control = options.control](double) { control->check(); });
        const std::int64_t frames = reader.count(options.data.frame + 1);
        if (frames == 0 || frames > options.data.frame) throw;
        options.data.frame = frames - 1;
    }
    return load_scene(path, options);
}

}  // namespace

bool finish(std::optional<Work>& work) {
    if (!work || !work->job.ended()) return false;
    const Work ended = *std::exchange(work, std::nullopt);
    try {
        ended.job.rethrow();
    } catch (...) {
        ended.fail(describe_current_exception(ended.path).message);
        return true;
    }
    ended.done();
    return true;
}

bool is_read_at_once(const std::string& path) {
    if (path == standard_stream) return false;
    std::error_code error;
    const fs::file_status status = fs::status(path_from(path), error);
    if (!fs::exists(status) || fs::is_directory(status)) return true;
    return fs::is_regular_file(status) && fs::file_size(path_from(path), error) <= bytes_at_once;
}

void start_loading(ViewerState& state, LoadRequest request) {
    const auto kept = state.autosave.keep_before_reading(state.document, edited_file(state));
    const bool waits = kept && !kept->ended();
    const bool at_once = !waits && is_read_at_once(request.path) && state.scene().spheres.size() <= spheres_at_once;
    auto loaded = std::make_shared<LoadedScene>();
    BackgroundJob job([loaded, kept, path = request.path, options = request.options,
                       or_last = request.or_last_frame](WorkControl& control) mutable {
        if (kept) kept->wait();
        options.control = &control;
        *loaded = or_last ? load_frame_or_last(path, options) : load_scene(path, options);
    });
    state.loading.reset();
    state.loading.emplace(Work{.path = std::move(request.path),
                               .job = std::move(job),
                               .done = [loaded, accept = std::move(request.accept)] { accept(std::move(*loaded)); },
                               .fail = std::move(request.fail),
                               .cancel = std::move(request.cancel),
                               .reload = request.reload});
    if (!at_once) return;
    state.loading->job.wait();
    finish(state.loading);
}

void cancel_work(ViewerState& state) {
    std::optional<Work>& work = state.loading ? state.loading : state.exporting ? state.exporting : state.comparing;
    if (!work) return;
    work->job.cancel();
    // A file that is whole in a moment needs no words.
    const bool may_appear = work->job.control().writes && !work->job.wait_for(unnoticed);
    const Work cancelled = *std::exchange(work, std::nullopt);
    if (may_appear) announce(state, "Cancelled too late: the picture may be written all the same");
    cancelled.cancel();
}

void start_saving(ViewerState& state, const std::string& path, SceneFormat format, std::function<void()> done,
                  std::function<void(const std::string& why)> fail) {
    const bool was_regular = path == state.path && (!state.stamp.empty() || state.gone_at);
    try {
        BackgroundJob job([scene = std::make_shared<Scene>(state.scene()), path, format, was_regular](WorkControl&) mutable {
            const std::string text = write_scene(*scene, format);
            scene.reset();
            if (was_regular) {
                write_regular_file(path, text);
            } else {
                write_output(path, text);
            }
        });
        state.saving.emplace(Work{.path = path, .job = std::move(job), .done = std::move(done), .fail = fail});
    } catch (...) {
        return fail(describe_current_exception(path).message);
    }
    if (state.scene().spheres.size() <= spheres_at_once && state.saving->job.wait_for(unnoticed)) finish(state.saving);
}

bool is_working(const ViewerState& state) {
    return state.loading || state.saving || state.exporting || state.comparing || state.copying || state.selecting;
}

std::optional<WorkShown> work_of(const ViewerState& state) {
    if (state.saving) return WorkShown{"Saving " + on_one_line(state.saving->path), {}, false};
    if (!state.loading && !state.exporting) {
        if (!state.comparing) return {};
        return WorkShown{"Comparing " + on_one_line(state.comparing->path), {}, true};
    }
    const WorkControl& control = state.loading ? state.loading->job.control() : state.exporting->job.control();
    const double done = static_cast<double>(control.done);
    const double total = static_cast<double>(control.total);
    if (!state.loading) {
        return WorkShown{"Exporting " + state.exporting->shown_path(), total > 0.0 ? done / total : 0.0, true};
    }
    std::string text = "Reading " + on_one_line(state.loading->path) + ": " + fixed(1e-6 * done, 0);
    if (total > 0.0) text += " of " + fixed(1e-6 * total, 0);
    return WorkShown{text + " MB", total > 0.0 ? std::optional(std::min(done / total, 1.0)) : std::nullopt, true};
}

bool finish_work(ViewerState& state) {
    bool any = false;
    // Saving first: its end may replace what is being loaded.
    for (std::optional<Work>* work :
         {&state.saving, &state.loading, &state.exporting, &state.filming, &state.comparing, &state.copying, &state.selecting}) {
        any = finish(*work) || any;
    }
    return any;
}

void finish_writing(ViewerState& state, std::chrono::milliseconds limit) {
    const auto last = Clock::now() + limit;
    const auto ends = [&](const Work& work) {
        return work.job.wait_for(std::max(std::chrono::duration_cast<std::chrono::milliseconds>(last - Clock::now()), {}));
    };
    for (std::optional<Work>* work : {&state.exporting, &state.filming}) {
        if (!*work) continue;
        (*work)->job.cancel();
        (*work)->stop();
    }
    for (std::optional<Work>* work : {&state.exporting, &state.filming}) {
        if (*work) ends(**work);
        work->reset();
    }
    while (state.saving && ends(*state.saving)) finish(state.saving);
}

}  // namespace sphereview

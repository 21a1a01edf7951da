#include "viewer/scene_work.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/failure.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t bytes_at_once = std::uintmax_t{1} << 20;
constexpr std::size_t spheres_at_once = 10'000;

void end_loading(ViewerState& state) {
    Loading ended = std::move(*state.loading);
    state.loading.reset();
    try {
        ended.job.rethrow();
    } catch (...) {
        return ended.request.fail(describe_current_exception(ended.request.path).message);
    }
    ended.request.accept(std::move(*ended.loaded));
}

void end_saving(ViewerState& state) {
    Saving ended = std::move(*state.saving);
    state.saving.reset();
    try {
        ended.job.rethrow();
    } catch (...) {
        return ended.fail(describe_current_exception().message);
    }
    ended.done();
}

}  // namespace

bool is_read_at_once(const std::string& path) {
    if (path == standard_stream) return false;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status) || fs::is_directory(status)) return true;
    return fs::is_regular_file(status) && fs::file_size(path, error) <= bytes_at_once;
}

void start_loading(ViewerState& state, LoadRequest request) {
    state.loading.reset();
    if (is_read_at_once(request.path)) {
        LoadedScene loaded;
        try {
            loaded = load_scene(request.path, request.options);
        } catch (...) {
            return request.fail(describe_current_exception(request.path).message);
        }
        return request.accept(std::move(loaded));
    }
    auto loaded = std::make_shared<LoadedScene>();
    BackgroundJob job([loaded, path = request.path, options = request.options](WorkControl& control) mutable {
        options.control = &control;
        *loaded = load_scene(path, options);
    });
    state.loading.emplace(Loading{std::move(request), std::move(loaded), std::move(job)});
}

bool cancel_work(ViewerState& state) {
    if (!state.loading) {
        const bool exported = state.exporting.has_value();
        state.exporting.reset();
        return exported;
    }
    const std::function<void()> cancel = std::move(state.loading->request.cancel);
    state.loading.reset();
    cancel();
    return true;
}

void start_saving(ViewerState& state, const std::string& path, SceneFormat format, std::function<void()> done,
                  std::function<void(const std::string& why)> fail) {
    if (state.scene().spheres.size() <= spheres_at_once) {
        try {
            write_output(path, write_scene(state.scene(), format));
        } catch (...) {
            return fail(describe_current_exception().message);
        }
        return done();
    }
    BackgroundJob job([scene = std::make_shared<Scene>(state.scene()), path, format](WorkControl&) mutable {
        const std::string text = write_scene(*scene, format);
        scene.reset();
        write_output(path, text);
    });
    state.saving.emplace(Saving{path, std::move(done), std::move(fail), std::move(job)});
}

bool is_working(const ViewerState& state) { return state.loading || state.saving || state.exporting; }

bool finish_work(ViewerState& state) {
    const bool loaded = state.loading && state.loading->job.ended();
    const bool saved = state.saving && state.saving->job.ended();
    if (saved) end_saving(state);
    // The end of saving may have replaced what was being loaded.
    if (loaded && state.loading && state.loading->job.ended()) end_loading(state);
    const bool exported = finish_export(state);
    return loaded || saved || exported;
}

void wait_for_saving(ViewerState& state) {
    while (state.saving) {
        state.saving->job.wait();
        end_saving(state);
    }
}

}  // namespace sphereview

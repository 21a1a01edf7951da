// sphereview [SCENE]: the window.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/background_job.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/memory.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"
#include "platform/gl_context.hpp"
#include "viewer/offer_recovery.hpp"
#include "viewer/recovery.hpp"
#include "viewer/scene_file.hpp"
#include "viewer/scene_saving.hpp"
#include "viewer/viewer.hpp"
#include "viewer/window_icon.hpp"

namespace sphereview {

namespace {

// on_connection_lost() gets no argument and reads this.
ViewerState* open_state = nullptr;

constexpr std::chrono::milliseconds patience_without_window{300};
constexpr std::chrono::seconds patience{2};  // with a window that does not act on a signal, and a disk that does not write

constexpr std::chrono::seconds patience_with_disk{20};  // from a signal to the end of the process, whatever hangs
constexpr const char* disk_hangs = "sphereview: the folder of unsaved changes does not answer; the last ones may be lost";

// The message when the loop hangs while it changes the document, which no other thread can read then.
constexpr const char* hangs_in_change =
    "sphereview: does not answer; the unsaved changes that were kept last are offered by the next start";

constexpr const char* way_out = " ('sphereview render' needs no window; 'sphereview doctor' says what works here)";

void say_of_edits(const std::string& said) {
    if (!said.empty()) say("sphereview: " + said);
}

[[noreturn]] void on_connection_lost() {
    std::string said = "the connection to the display is lost";
    if (open_state != nullptr) {
        finish_writing(*open_state, patience);
        open_state->autosave.finish();
        const std::string kept = keep_unsaved(*open_state);
        if (!kept.empty()) said += "; " + kept;
        save_settings(settings_to_keep(*open_state));
    }
    say("sphereview: " + said + way_out);
    std::fflush(stderr);  // of all, one may be locked: a read of standard input waits on another thread
    std::_Exit(static_cast<int>(ExitCode::no_renderer));
}

void adopt_first_scene(ViewerState& state, LoadedScene loaded) {
    with_options(loaded.scene, state.light);  // what does not fit the scene is said now
    const FitOptions& fit = state.options.fit;
    const std::optional<Camera> view =
        fit.saved_view ? std::optional(saved_view(loaded, *fit.saved_view)) : std::nullopt;  // likewise
    // Data is fitted already, in perspective.
    const bool fits_view = loaded.has_camera() ? fit.wanted.value_or(false) : fit.projection && fit.wanted.value_or(true);
    adopt(state, std::move(loaded), *state.options.scene);
    state.frame = state.options.data.frame;
    state.camera = view.value_or(state.camera);
    state.camera.projection = fit.projection.value_or(state.camera.projection);
    if (fits_view) {
        const ViewAxes present = axes_of(state.camera);
        const ViewAxes axes = with_hand_of(present, fit.view.value_or(present));
        state.camera = fitted(state.scene(), axes, state.camera.projection).value_or(state.camera);
    }
}

void set_icon(Window& window) {
    std::vector<Window::Icon> sizes;
    for (const Image& icon : window_icons()) sizes.push_back({icon.width(), {icon.bytes().begin(), icon.bytes().end()}});
    window.set_icon(std::move(sizes));
}

// A small scene is there, or refused, before there is a window; of another one this much is waited for.
void load_first_scene(ViewerState& state) {
    if (!state.options.scene) return adopt(state, {{}, "", SceneFormat::toml}, "");
    const std::string path = *state.options.scene;
    const LoadOptions options = load_options(state, path, state.options.data.frame);
    if (is_read_at_once(path)) return adopt_first_scene(state, load_scene(path, options));
    adopt(state, {{}, "", SceneFormat::toml}, "");
    const auto fail = [&state](const std::string& why) { report_error(state, "The scene cannot be opened", why); };
    const auto accept = unless_edited(state, [&state, fail](LoadedScene loaded) {
        try {
            adopt_first_scene(state, std::move(loaded));
        } catch (const InputError& error) {
            fail(error.what());
        }
    });
    start_loading(state, {.path = path, .options = options, .accept = accept, .fail = fail});
    if (!state.loading->job.wait_for(patience_without_window)) return;
    state.loading->job.rethrow();
    finish_work(state);
}

}  // namespace

ExitCode run_view(const ViewOptions& options) {
    return_large_blocks();
    std::string unreadable;
    ViewerState state(options, load_settings(&unreadable));
    if (!unreadable.empty()) say(unreadable + "; the settings begin anew");
    state.background = options.background;
    state.light = options.light;
    if (options.shading) state.settings.shading = *options.shading;
    if (options.light.any()) state.settings.shading = Shading::studio;
    if (options.size) {
        state.settings.export_width = state.settings.film_width = options.size->width;
        state.settings.export_height = state.settings.film_height = options.size->height;
    }
    if (options.samples) state.settings.samples = *options.samples;
    load_first_scene(state);
    offer_recovery(state);
    try {
        require_address_space_for_gl();
        Window window("sphereview", state.settings.place);
        open_state = &state;
        Window::set_connection_lost_handler(on_connection_lost);
        // Only now: until there is a window, an interruption ends the program at once, also while it waits for standard input.
        static std::atomic<int> interrupted = 0;
        static std::promise<void> loop_ended;
        static std::promise<void> edits_kept;
        pass_interrupts_to([&state](int signal_number) {
            interrupted = signal_number;
            Window::wake();
            // The disk of the unsaved changes may not answer either. What stands there stays whole.
            const BackgroundJob bound([signal_number](WorkControl&) {
                std::this_thread::sleep_for(patience_with_disk);
                say(disk_hangs);
                std::_Exit(128 + signal_number);
            });
            const std::future<void> ended = loop_ended.get_future();
            const auto has_ended = [&](std::chrono::seconds limit) { return ended.wait_for(limit) == std::future_status::ready; };
            if (!has_ended(patience)) {
                const std::optional<std::string> said = keep_unsaved_of_hung_loop(state, patience);
                if (said) {
                    say_of_edits(*said);
                } else if (!has_ended(std::chrono::seconds(0))) {
                    say(hangs_in_change);
                }
            }
            if (has_ended(std::chrono::seconds(0))) {
                edits_kept.get_future().wait();
                std::this_thread::sleep_for(patience);  // closing a window may hang too
            }
            std::_Exit(128 + signal_number);
        });
        Viewer viewer(state, window);
        set_icon(window);
        window.show();
        leave_own_console();
        // Held to the end: from here on, this thread alone keeps the edits.
        std::unique_lock ending(state.changing, std::defer_lock);
        try {
            viewer.run([] { return interrupted.load() != 0; });
            ending.lock();
            loop_ended.set_value();
        } catch (...) {
            ending.lock();
            loop_ended.set_value();
            finish_writing(state, patience);
            state.autosave.finish();
            say_of_edits(keep_unsaved(state));
            edits_kept.set_value();
            throw;
        }
        finish_writing(state, patience);
        state.autosave.finish();
        open_state = nullptr;
        if (interrupted != 0) {
            say_of_edits(keep_unsaved(state));
            edits_kept.set_value();
            save_settings(settings_to_keep(state));
            return static_cast<ExitCode>(128 + interrupted.load());
        }
        remove_own_recovery();  // saved, or not wanted
        edits_kept.set_value();
        state.settings.place = window.place();
    } catch (const RenderError& error) {
        throw RenderError(std::string("sphereview: ") + error.what() + way_out);
    }
    save_settings(settings_to_keep(state));
    return ExitCode::done;
}

}  // namespace sphereview

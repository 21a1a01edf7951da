// Reading and writing scenes beside the window's loop, and what else goes on there.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/load_scene.hpp"
#include "base/background_job.hpp"
#include "base/text.hpp"
#include "panels/status.hpp"
#include "viewer/made_beside.hpp"

namespace sphereview {

struct ViewerState;

// What is to be read, and what is called then: one of the three, in the loop. Another request, or the end of the state, calls
// none of them.
struct LoadRequest {
    std::string path{};
    LoadOptions options{};
    std::function<void(LoadedScene)> accept{};
    std::function<void(const std::string& why)> fail{};
    std::function<void()> cancel = [] {};
    bool reload = false;         // of the file that is shown
    bool or_last_frame = false;  // where the file has fewer frames than the one that is asked for: the last it has
};

// What a thread beside the window's loop does with a file, and what the loop does once it has ended: done(), or fail() where the
// thread throws. Work that is cancelled calls neither.
struct Work {
    std::string path;
    BackgroundJob job;
    std::function<void()> done;
    std::function<void(const std::string& why)> fail;
    std::function<void()> cancel = [] {};
    bool reload = false;                                          // it reads the file that is shown
    bool then_quit = false;                                       // the person has closed the window meanwhile
    std::shared_ptr<const HandedOver<std::string>> found_path{};  // instead of `path`, where the job chooses: "" until then
    std::function<WorkShown()> words{};                           // what is told of a film
    // Ends what a job waits for that is cancelled; whether what it writes will not appear then.
    std::function<bool()> stop = [] { return false; };

    std::string shown_path() const {
        const std::string shown = found_path ? found_path->get() : path;
        return shown.empty() ? "the view" : on_one_line(shown);  // its name is not found yet
    }
};

// Acts on it if it has ended. Returns whether it has.
bool finish(std::optional<Work>& work);

// Whether to read it at once: a regular file that takes no time that anyone sees, or what is missing and says so.
bool is_read_at_once(const std::string& path);

// Begins to read, instead of what is being read now. What is_read_at_once() has been read when this returns: before anyone could
// see a bar. A reading that was cancelled ends at its next 4 MB; nobody waits for it, since a read of a pipe may never return.
void start_loading(ViewerState& state, LoadRequest request);
// What is being read, or else exported, or else compared; says so if it is already being written, and leaves nothing else. A film,
// which may take hours, is not given up in passing (viewer/film_export.hpp).
void cancel_work(ViewerState& state);

// Writes the scene as it is now, from a copy (10 ms for a million spheres), so that edits need not wait and cannot tear what is
// written. A small one is usually written when this returns; a FIFO that nobody reads, or a disk that hangs, is not waited for.
// None may be under way. `done` is called once the file is whole. A FIFO or a device that came in the place of the scene's own
// regular file is refused: nobody chose it.
void start_saving(ViewerState& state, const std::string& path, SceneFormat format, std::function<void()> done,
                  std::function<void(const std::string& why)> fail);

// Whether something is read, written, exported, compared, copied or looked for in a box: then finish_work() has to be called again
// and again, as while a film is made, for which nobody waits.
bool is_working(const ViewerState& state);
// In words.
std::optional<WorkShown> work_of(const ViewerState& state);
// Acts on what has ended. Returns whether anything has.
bool finish_work(ViewerState& state);
// Cancels an export and a film; waits for what is being written all the same, at most so long, and acts on what is saved.
void finish_writing(ViewerState& state, std::chrono::milliseconds limit);

}  // namespace sphereview

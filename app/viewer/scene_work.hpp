// Reads and writes scenes beside the window's loop, and finishes all other work there.
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

// What to read, and three functions, one of which the loop calls at the end. Another request, or the end of the state, calls none.
struct LoadRequest {
    std::string path{};
    LoadOptions options{};
    std::function<void(LoadedScene)> accept{};
    std::function<void(const std::string& why)> fail{};
    std::function<void()> cancel = [] {};
    bool reload = false;         // reads the shown file again
    bool or_last_frame = false;  // takes the last frame if the file has not so many
};

// A job with a file beside the window's loop. When it has ended the loop calls done(), or fail() if the job threw. Cancelled work
// calls neither.
struct Work {
    std::string path;
    BackgroundJob job;
    std::function<void()> done;
    std::function<void(const std::string& why)> fail;
    std::function<void()> cancel = [] {};
    bool reload = false;                                          // reads the shown file
    bool then_quit = false;                                       // the person has closed the window
    std::shared_ptr<const HandedOver<std::string>> found_path{};  // replaces `path` when the job has chosen a name; "" until then
    std::function<WorkShown()> words{};                           // a film's progress in words
    // Ends what a cancelled job waits for. Returns whether its output will not appear.
    std::function<bool()> stop = [] { return false; };

    std::string shown_path() const {
        const std::string shown = found_path ? found_path->get() : path;
        return shown.empty() ? "the view" : on_one_line(shown);  // "": no name is chosen yet
    }
};

// Finishes work that has ended. Returns whether it has ended.
bool finish(std::optional<Work>& work);

// Whether to read the file without a job: it is small and regular, or missing, which is an error at once.
bool is_read_at_once(const std::string& path);

// Begins to read, in place of an earlier reading. A file that is_read_at_once() is read on return. A cancelled reading ends at its
// next 4 MB; nobody waits for it, since a read of a pipe may never return.
void start_loading(ViewerState& state, LoadRequest request);
// Cancels a reading, else an export, else a comparison; says so if the output is being written already. A film is cancelled by its
// own button alone (viewer/film_export.hpp).
void cancel_work(ViewerState& state);

// Writes the present scene from a copy (10 ms for a million spheres), so that edits need not wait. A small scene is usually written
// on return; a FIFO that nobody reads, or a disk that hangs, is not waited for. No other save may be under way. Calls `done` when
// the file is whole. Refuses a FIFO or a device that has replaced the scene's own regular file: nobody chose it.
void start_saving(ViewerState& state, const std::string& path, SceneFormat format, std::function<void()> done,
                  std::function<void(const std::string& why)> fail);

// Whether something is read, written, exported, compared, copied or looked for in a box, apart from a film. Meanwhile, and while a
// film is made, call finish_work() again and again.
bool is_working(const ViewerState& state);
// The present work in words.
std::optional<WorkShown> work_of(const ViewerState& state);
// Finishes all work that has ended. Returns whether there was any.
bool finish_work(ViewerState& state);
// Cancels an export and a film. Waits at most `limit` for outputs that are being written, and finishes a save.
void finish_writing(ViewerState& state, std::chrono::milliseconds limit);

}  // namespace sphereview

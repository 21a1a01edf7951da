// Unsaved edits that survive the end of the program, in base/user_folders.hpp's state_folder().
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/background_job.hpp"
#include "base/file_watcher.hpp"
#include "edit/document.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct ViewerState;

// Which frame of a file was edited, and the state of the file when the frame was read.
struct EditedFrame {
    std::int64_t number = 0;
    std::int64_t file_size = 0;  // bytes
    std::int64_t file_time = 0;  // of the last write, in the file system's units
    bool has_numbers = false;    // the spheres' numbers are still those of the file

    bool operator==(const EditedFrame&) const = default;
};

// Frame `number` with the file's present state; nothing where there is no regular file.
std::optional<EditedFrame> edited_frame(const FileStates& file, std::int64_t number, bool has_numbers);

// The file that was being edited.
struct EditedFile {
    std::string path{};  // absolute; "" for an untitled scene
    std::optional<EditedFrame> frame{};

    bool operator==(const EditedFile&) const = default;
};

EditedFile edited_file(const ViewerState& state);

struct Recovery {
    std::string file;  // a native scene, to be read as any other
    EditedFile original;
    std::chrono::system_clock::time_point time;
};

inline constexpr std::size_t all_spheres = std::numeric_limits<std::size_t>::max();

// Keeps the scene for a later run, whole or not at all, in place of what this process kept before. False on failure. The scene
// lacks changes of spheres from the number `complete_up_to` on. A copy that has more of these changes stays beside it, as a
// recovery of its own, until a scene as complete is kept.
bool write_recovery(const Scene& scene, const EditedFile& original, std::size_t complete_up_to = all_spheres) noexcept;

// What processes that have ended kept, the newest first. A running process holds a lock on its recovery; the system releases the
// lock when the process ends, however it ends.
std::vector<Recovery> list_recoveries();

// The recovery in one line for a person, whatever the file holds.
std::string in_words(const Recovery& recovery);

// Recoveries on file systems that cannot lock: their process may still run.
std::vector<std::string> unclear_recoveries();

// False when the file is still there afterwards.
bool remove_recovery(const std::string& file) noexcept;

// Forgets what this process has kept: its edits were saved after all.
bool remove_own_recovery() noexcept;

// Keeps unsaved changes in the recovery file while the viewer runs, so that not even a kill or a power cut loses more than seconds.
class Autosave {
public:
    using Clock = std::chrono::steady_clock;

    // Call when nothing moves. Keeps changes that are some seconds old, from a copy, beside the loop. The longer the last write
    // took, the longer the pause, so that writing takes a small part of the time. Forgets what is kept as soon as nothing is
    // unsaved. `original`: the file of the document.
    void look(const Document& document, const EditedFile& original, Clock::time_point now);

    // Waits until the write in progress is on the disk or has failed.
    void finish();

    // Keeps the changes at once. False on failure; look() then tries again after the next change.
    bool keep(const Document& document, const EditedFile& original);

    // Begins to keep changes that are not kept yet, before something is read that may end the program. They are kept when the
    // returned job, if any, has ended.
    std::shared_ptr<const BackgroundJob> keep_before_reading(const Document& document, const EditedFile& original);

    // Call when the document has become another frame of the same file. If this frame lacks spheres that were changed in others,
    // the kept copy stays: alone until the document changes, then beside the document's own copy.
    void shows_frame(const Document& document, bool lacks_changed_spheres);

    // Keeps the changes as the program ends, without a thread or a copy. Nothing may be being written. False on failure.
    bool keep_at_end(const Document& document, const EditedFile& original) const;

    // When to call look() although no input comes.
    std::optional<Clock::time_point> due() const { return due_; }

private:
    void begin(const Document& document, const EditedFile& original);

    std::optional<Clock::time_point> due_;
    Clock::duration pause_ = shortest_pause;
    std::uint64_t tried_ = 0;                   // the revision of the last attempt
    std::uint64_t instead_of_ = 0;              // the revision of a frame for which an earlier copy stays
    bool kept_ = false;                         // there may be a recovery file of ours
    std::size_t complete_up_to_ = all_spheres;  // of the document, for write_recovery()
    // The state of the last written copy; the job's thread sets it.
    struct Written {
        std::atomic<bool> done = false;
        std::atomic<Clock::duration> took = Clock::duration::zero();
    };

    std::shared_ptr<BackgroundJob> job_;
    std::shared_ptr<Written> written_ = std::make_shared<Written>();

    static constexpr Clock::duration shortest_pause = std::chrono::seconds(2);
    static constexpr int pauses_per_write = 20;
    static constexpr Clock::duration look_again = std::chrono::milliseconds(250);  // while a job runs
};

// Keeps unsaved changes when the program ends unasked. Returns a message about the outcome; "" when nothing is unsaved.
std::string keep_unsaved(const ViewerState& state);

// The same from another thread while the loop hangs. The loop, should it go on, can change nothing more. Nothing when the loop
// stays in the middle of a change for longer than `limit`.
std::optional<std::string> keep_unsaved_of_hung_loop(ViewerState& state, std::chrono::milliseconds limit);

}  // namespace sphereview

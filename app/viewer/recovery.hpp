// Unsaved edits that survive the end of the program, in the platform's folder for such things.
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

// A frame of a file of several, as that was when the frame was read.
struct EditedFrame {
    std::int64_t number = 0;
    std::int64_t file_size = 0;  // bytes
    std::int64_t file_time = 0;  // of the last write, in the file system's units
    bool has_numbers = false;    // the spheres' numbers are still those of the file

    bool operator==(const EditedFrame&) const = default;
};

// That frame of the file as it is; nothing where there is no regular file.
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

// Keeps the scene for a later run, whole or not at all, instead of what this process kept before. False when that cannot be
// done; for emergencies, so it throws nothing. The scene has the changes of spheres below the number `complete_up_to` alone: what
// was kept of more of them stays beside it, as a recovery of its own, until a scene is kept that has as many.
bool write_recovery(const Scene& scene, const EditedFile& original, std::size_t complete_up_to = all_spheres) noexcept;

// What processes that no longer run have kept, the newest first. Whether one still runs is told by the lock that it holds: the
// system lets go of the lock when the process ends, however it ends.
std::vector<Recovery> list_recoveries();

// What a person is told of it: whatever the file holds, one line.
std::string in_words(const Recovery& recovery);

// What may be left behind or may be a running process's: nothing tells where the file system cannot lock.
std::vector<std::string> unclear_recoveries();

// False when the file is still there afterwards.
bool remove_recovery(const std::string& file) noexcept;

// Forgets what this process has kept: its edits were saved after all.
bool remove_own_recovery() noexcept;

// Keeps unsaved changes in the recovery file while the viewer runs, so that not even a kill or a power cut loses more than seconds.
class Autosave {
public:
    using Clock = std::chrono::steady_clock;

    // Call when nothing moves. Keeps the changes once they are some seconds old; the longer that took the last time, the later, so
    // that it never takes more than a small part of the time; from a copy, beside the loop. Forgets what is kept as soon as nothing
    // is unsaved. `original` is what the document is of.
    void look(const Document& document, const EditedFile& original, Clock::time_point now);

    // What is being written is on the disk, or has failed, when this returns.
    void finish();

    // Keeps the changes at once. False when that cannot be done; it is not tried again before the next change.
    bool keep(const Document& document, const EditedFile& original);

    // Begins to keep the changes, if they are not kept: what is read next may end the program. They are kept once what this
    // returns, if it is anything, has ended.
    std::shared_ptr<const BackgroundJob> keep_before_reading(const Document& document, const EditedFile& original);

    // The document is another frame of the same file now. If that lacks spheres which were changed in others, what is kept has them
    // and stays: alone, until this document changes, then beside what is kept of it.
    void shows_frame(const Document& document, bool lacks_changed_spheres);

    // As the program ends, when nothing is being written: without a thread or a copy. False when the changes cannot be kept.
    bool keep_at_end(const Document& document, const EditedFile& original) const;

    // When look() has something to do that no input announces.
    std::optional<Clock::time_point> due() const { return due_; }

private:
    void begin(const Document& document, const EditedFile& original);

    std::optional<Clock::time_point> due_;
    Clock::duration pause_ = shortest_pause;
    std::uint64_t tried_ = 0;                   // the revision of the last attempt,
    std::uint64_t instead_of_ = 0;              // or of the frame instead of which what is kept stays
    bool kept_ = false;                         // there may be a recovery file of ours
    std::size_t complete_up_to_ = all_spheres;  // the document, as write_recovery() has it
    // Of the last copy that was written; the job's thread sets them.
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

// Keeps what is not saved for the next start, as the program ends unasked, and says what became of it, for a message; "" when there
// is nothing.
std::string keep_unsaved(const ViewerState& state);

// The same by another thread than that of the loop, which hangs. Should the loop go on meanwhile, it changes nothing until the
// process has ended. Nothing when the loop is in the middle of a change for longer than that.
std::optional<std::string> keep_unsaved_of_hung_loop(ViewerState& state, std::chrono::milliseconds limit);

}  // namespace sphereview

// Steps through and plays the frames of the scene's file, and seeks them by a handle. Frames are read beside the loop; the frame
// that was asked for last is shown next.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "base/file_watcher.hpp"
#include "panels/timeline.hpp"
#include "viewer/frame_edits.hpp"
#include "viewer/frames_ahead.hpp"
#include "viewer/play_clock.hpp"

namespace sphereview {

struct ViewerState;

struct WantedFrame {
    std::int64_t frame = 0;
    bool by_clock = false;         // else by the person
    std::int64_t passed_over = 0;  // frames on the way that cannot be read
    std::string fault{};           // the fault of the first of these
};

// The player's state.
struct FramePlayer {
    PlayChoices choices{};
    PlayClock clock{};
    std::unique_ptr<FramesAhead> ahead{};     // null until a frame is asked for, or frames are to be counted
    FileStates opened{};                      // the file's when `ahead` opened it
    FileStates shown{};                       // the shown scene's at that time
    bool all_properties = false;              // ViewerState's at that time
    bool all_frames = true;                   // ViewerState::frames counts all frames of the file
    double counted = 0.0;                     // else the part of the file that was looked through, 0..1
    std::optional<FrameTime> time{};          // of the shown frame, if the file has times
    std::optional<double> usual_step{};       // time from a frame to the next, > 0; nothing while unknown
    std::optional<double> radius{};           // of the file's points, if made of their distances
    std::optional<WantedFrame> wanted{};      // to be shown as soon as it is read
    std::int64_t step = 0;                    // the last one, 1 or -1; 0: a jump
    std::optional<std::uint64_t> given_up{};  // the document's revision whose edits may be lost
    FrameEdits edits{};
    EditsBeyondReloads reloads{};
    std::set<std::string> said{};  // readers' messages, each shown once while a film plays
};

// Whether the scene's file has several frames.
bool has_several_frames(const ViewerState& state);
// Whether the file is known to have that frame.
bool has_frame(const ViewerState& state, std::int64_t frame);

// Notes the frames of a file that was opened or read again.
void begin_frames(ViewerState& state, const LoadedScene& loaded);
// The document's file has no frames any more.
void end_frames(ViewerState& state);

// Shows another frame of the scene's file with the same view and, if it has as many spheres, the same selection and measured
// spheres. Asks about unsaved edits of this frame alone. A frame of a small file is shown at once, others by follow_player(),
// unless another frame is asked for before.
void show_frame(ViewerState& state, std::int64_t frame);

// The same, and stops the playing.
void stop_at_frame(ViewerState& state, std::int64_t frame);

void play_or_pause(ViewerState& state);
// Plays; begins with the first frame if the last one is shown and nothing repeats.
void play_frames(ViewerState& state);

// Shows what has come since the last call. `held`: something is dragged or typed, so the frame must not change.
enum class FrameNews { none, frame, stopped, counted };
FrameNews follow_player(ViewerState& state, PlayClock::Time now, bool held);

// About how many frames a second play.
double frames_a_second(const ViewerState& state);

// When to call follow_player() for the next frame; nothing while nothing plays.
std::optional<PlayClock::Time> next_frame_due(const ViewerState& state);
// Whether to call it again and again: a wanted frame is being read, or frames are counted.
bool reads_frames(const ViewerState& state);

TimelineFacts timeline_facts(ViewerState& state);

}  // namespace sphereview

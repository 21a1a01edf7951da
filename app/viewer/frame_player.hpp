// The frames of the scene's file, one after the other: stepped through, played, and looked for by a handle. They are read beside
// the loop; whatever is asked for meanwhile, the latest frame that was asked for is shown next.
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
    std::int64_t passed_over = 0;  // frames on the way that cannot be read,
    std::string fault{};           // and what is said of the first of them
};

// What the viewer remembers of them.
struct FramePlayer {
    PlayChoices choices{};
    PlayClock clock{};
    std::unique_ptr<FramesAhead> ahead{};     // null until a frame is asked for, or frames are to be counted
    FileStates opened{};                      // of the file when `ahead` opened it,
    FileStates shown{};                       // and of what was shown then
    bool all_properties = false;              // ViewerState's, then
    bool all_frames = true;                   // ViewerState::frames are all that the file has
    double counted = 0.0;                     // else: which part of it is looked through, 0..1
    std::optional<FrameTime> time{};          // of the frame that is shown, where the file has it
    std::optional<double> usual_step{};       // of the time, from a frame to the next; > 0. Nothing while that is not known
    std::optional<double> radius{};           // that the file's points have, where they have one of their distances
    std::optional<WantedFrame> wanted{};      // that is to be shown as soon as it is read
    std::int64_t step = 0;                    // the last one, 1 or -1; 0: it went farther
    std::optional<std::uint64_t> given_up{};  // the document's revision of which edits may be lost
    FrameEdits edits{};
    EditsBeyondReloads reloads{};
    std::set<std::string> said{};  // what the readers had to say of frames: once while a film plays
};

// Whether the scene's file has several frames.
bool has_several_frames(const ViewerState& state);
// Whether the file has that frame, as far as that is known.
bool has_frame(const ViewerState& state, std::int64_t frame);

// Another file, or what it holds now: notes its frames.
void begin_frames(ViewerState& state, const LoadedScene& loaded);
// There is no file of several frames any more.
void end_frames(ViewerState& state);

// Shows another frame of the scene's file, with the same view and, of as many spheres, the same selection and measured spheres.
// Asks about edits that the others do not get, and are not saved. A frame of a small file is there when this returns; another one
// comes in follow_player(), unless yet another is asked for before.
void show_frame(ViewerState& state, std::int64_t frame);

// The same, and stops the playing.
void stop_at_frame(ViewerState& state, std::int64_t frame);

void play_or_pause(ViewerState& state);
// Plays, from the first frame where the last is shown and nothing repeats.
void play_frames(ViewerState& state);

// What has come of the film since the last call, for the loop. `held`: something is in the hand, for which no frame is to change.
enum class FrameNews { none, frame, stopped, counted };
FrameNews follow_player(ViewerState& state, PlayClock::Time now, bool held);

// How many frames a second are to be seen, about.
double frames_a_second(const ViewerState& state);

// When follow_player() is to be called for the next frame; nothing while nothing plays.
std::optional<PlayClock::Time> next_frame_due(const ViewerState& state);
// Whether it is to be called again and again: a frame is read that is waited for, or frames are counted.
bool reads_frames(const ViewerState& state);

TimelineFacts timeline_facts(ViewerState& state);

}  // namespace sphereview

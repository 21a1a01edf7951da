// The film of a file of several frames: its buttons and the line of time under the picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panels/number_field.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

struct PlaySpeed {
    double frames = 24.0;              // a second
    std::optional<double> recorded{};  // instead, where the file has times: so much of its time a second; > 0

    bool operator==(const PlaySpeed&) const = default;
};

inline constexpr std::array<double, 9> play_speeds = {1.0, 2.0, 5.0, 10.0, 15.0, 24.0, 30.0, 60.0, 120.0};

// Speeds of frames as they were recorded, of a file with so much time from a frame to the next, > 0: about as play_speeds.
std::vector<double> recorded_speeds(double usual_step);

// The next of play_speeds, up (1) or down (-1), or of recorded_speeds(); at the end the same.
PlaySpeed next_speed(const PlaySpeed& speed, std::optional<double> usual_step, int by);

// "24 / s", "5 ps / s", and "t 5 / s" where nobody knows the unit.
std::string words_of(const PlaySpeed& speed, const std::string& time_unit);

// "0.500 ps", "t 0.500".
std::string words_of_time(const std::string& number, const std::string& unit);

// What comes behind the last frame.
enum class Repeat { once, loop, back_and_forth };

struct PlayChoices {
    PlaySpeed speed{};
    Repeat repeat = Repeat::once;
    bool handle_held = false;      // the film goes on from where the handle is let go
    NumberFields numbers{};        // the frame's, which is typed or dragged as well
    std::size_t time_letters = 0;  // of the longest time of the file that was shown: what stands beside it keeps its place
};

// What the edits of the frame that is shown apply to.
enum class EditsReach { none, all_frames, this_frame };

struct TimelineFacts {
    bool playing = false;
    std::optional<std::int64_t> wanted{};  // the frame that is being read, to be shown
    bool counting = false;                 // the file may have more frames than are known
    double counted = 0.0;                  // which part of it is looked through, 0..1
    EditsReach edits = EditsReach::none;
    std::string time{};                  // of the frame that is shown, as the file has it: "0.500"; "" where it has none
    std::string time_unit{};             // "ps"; "" where nobody knows
    std::optional<double> usual_step{};  // of these times, from a frame to the next; > 0
    bool wanted_in_vain = false;         // `wanted` cannot be read
};

// How high what draw_timeline() draws is, without the window's edge.
float timeline_height();

// How wide it is at least, without the window's edges, that the number is not left out.
float least_timeline_width(const PanelContext& context, const TimelineFacts& facts);

// Draws into the current ImGui window, as wide as that is; what there is no room for is left out. Widgets: "first frame",
// "previous frame", "play", "next frame", "last frame", "timeline", "slider frame", "frame number",
// "frame time", "edits reach" or, where there is less room, "edits mark", "repeat", "speed", "speed 24 / s", "speed 5 ps / s".
void draw_timeline(const PanelContext& context, const TimelineFacts& facts, PlayChoices& choices);

}  // namespace sphereview

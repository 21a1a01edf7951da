// The buttons and the line of time for a file of several frames, under the picture.
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

// The speed of a playing film: frames a second, or the file's time a second.
struct PlaySpeed {
    double frames = 24.0;              // a second
    std::optional<double> recorded{};  // if set: the file's time a second, > 0

    bool operator==(const PlaySpeed&) const = default;
};

inline constexpr std::array<double, 9> play_speeds = {1.0, 2.0, 5.0, 10.0, 15.0, 24.0, 30.0, 60.0, 120.0};

// Speeds in the file's time, about as fast as play_speeds. `usual_step`: time from a frame to the next, > 0.
std::vector<double> recorded_speeds(double usual_step);

// The next of play_speeds or recorded_speeds(), up (1) or down (-1); the same at the end.
PlaySpeed next_speed(const PlaySpeed& speed, std::optional<double> usual_step, int by);

// "24 / s", "5 ps / s", or "t 5 / s" with an unknown unit.
std::string words_of(const PlaySpeed& speed, const std::string& time_unit);

// "0.500 ps", "t 0.500".
std::string words_of_time(const std::string& number, const std::string& unit);

// What follows the last frame.
enum class Repeat { once, loop, back_and_forth };

struct PlayChoices {
    PlaySpeed speed{};
    Repeat repeat = Repeat::once;
    bool handle_held = false;      // the film goes on where the handle is let go
    NumberFields numbers{};        // for the frame's number
    std::size_t time_letters = 0;  // of the longest time shown so far, so that what is beside it stays in place
};

// The frames that the shown frame's edits apply to.
enum class EditsReach { none, all_frames, this_frame };

struct TimelineFacts {
    bool playing = false;
    std::optional<std::int64_t> wanted{};  // the frame that is being read to be shown
    bool counting = false;                 // the file may have more frames than are known
    double counted = 0.0;                  // the counted part of the file, 0..1
    EditsReach edits = EditsReach::none;
    std::string time{};                  // of the shown frame, as in the file: "0.500"; "" for none
    std::string time_unit{};             // "ps"; "" if unknown
    std::optional<double> usual_step{};  // time from a frame to the next, > 0
    bool wanted_in_vain = false;         // `wanted` cannot be read
};

// The height of draw_timeline(), without the window's edge.
float timeline_height();

// The least width, without the window's edges, at which the number is shown.
float least_timeline_width(const PanelContext& context, const TimelineFacts& facts);

// Draws into the current ImGui window, over its width; leaves out what has no room. Widgets: "first frame", "previous frame",
// "play", "next frame", "last frame", "timeline", "slider frame", "frame number", "frame time", "edits reach" or, where there is
// less room, "edits mark", "repeat", "speed", "speed 24 / s", "speed 5 ps / s".
void draw_timeline(const PanelContext& context, const TimelineFacts& facts, PlayChoices& choices);

}  // namespace sphereview

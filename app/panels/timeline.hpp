// The film of a file of several frames: its buttons and the line of time under the picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "panels/number_field.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// What comes behind the last frame.
enum class Repeat { once, loop, back_and_forth };

struct PlayChoices {
    double speed = 24.0;  // frames a second
    Repeat repeat = Repeat::once;
    bool handle_held = false;  // the film goes on from where the handle is let go
    NumberFields numbers{};    // the frame's, which is typed or dragged as well
};

inline constexpr std::array<double, 9> play_speeds = {1.0, 2.0, 5.0, 10.0, 15.0, 24.0, 30.0, 60.0, 120.0};

// The next of play_speeds, up (1) or down (-1); at the end the same.
double next_speed(double speed, int by);

// What the edits of the frame that is shown apply to.
enum class EditsReach { none, all_frames, this_frame };

struct TimelineFacts {
    bool playing = false;
    std::optional<std::int64_t> wanted{};  // the frame that is being read, to be shown
    bool counting = false;                 // the file may have more frames than are known
    double counted = 0.0;                  // which part of it is looked through, 0..1
    EditsReach edits = EditsReach::none;
};

// How high what draw_timeline() draws is, without the window's edge.
float timeline_height();

// How wide it is at least, without the window's edges, that the number is not left out.
float least_timeline_width(const PanelContext& context, const TimelineFacts& facts);

// Draws into the current ImGui window, as wide as that is; what there is no room for is left out. Widgets: "first frame",
// "previous frame", "play", "next frame", "last frame", "timeline", "slider frame", "frame number",
// "edits reach" or, where there is less room, "edits mark", "repeat", "speed", "speed 24 / s".
void draw_timeline(const PanelContext& context, const TimelineFacts& facts, PlayChoices& choices);

}  // namespace sphereview

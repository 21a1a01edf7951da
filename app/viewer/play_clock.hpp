// When the next frame of a film is due, and which one it is. The caller gives the time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "panels/timeline.hpp"

namespace sphereview {

// How many frames of a file are known, and whether these are all.
struct KnownFrames {
    std::int64_t frames = 1;
    bool all = true;
};

class PlayClock {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Beat = Time::duration;  // from a frame to the next

    bool plays() const { return plays_; }
    // The first frame is due one beat later.
    void play(Time now);
    void pause() { plays_ = false; }

    // When the next frame is due.
    Time due(Beat beat) const { return last_ + beat; }
    // A frame is shown, `beat` after the one before. The next frames keep the beat, but a delay of more than a beat is not caught
    // up.
    void shown(Beat beat, Time now);
    // Call while something is dragged: no frame comes.
    void hold(Time now) { last_ = now; }

    // Steps to the next frame. Nothing where the film ends, or waits for frames to be found.
    std::optional<std::int64_t> step_from(std::int64_t frame, Repeat repeat, const KnownFrames& known);
    // The next frames that step_from() will give, at most `most`.
    std::vector<std::int64_t> next_ones(std::int64_t frame, Repeat repeat, const KnownFrames& known, std::size_t most) const;

private:
    bool plays_ = false;
    bool backward_ = false;
    Time last_{};
};

}  // namespace sphereview

// When the next frame of a film is due, and which one it is. Knows no clock of its own: it is told the time.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "panels/timeline.hpp"

namespace sphereview {

// Of a file: how many frames are known, and whether these are all.
struct KnownFrames {
    std::int64_t frames = 1;
    bool all = true;
};

class PlayClock {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Beat = Time::duration;  // between a frame and the next

    bool plays() const { return plays_; }
    // The first frame is due a while after that.
    void play(Time now);
    void pause() { plays_ = false; }

    // When the next frame is due.
    Time due(Beat beat) const { return last_ + beat; }
    // A frame has come to be shown, to which that was the beat. Those behind keep the beat; what is more than a beat late is not
    // caught up with.
    void shown(Beat beat, Time now);
    // While something is in the hand no frame comes.
    void hold(Time now) { last_ = now; }

    // Which one that is, and the next turns are from there. Nothing where the film ends, or waits for frames to be found.
    std::optional<std::int64_t> step_from(std::int64_t frame, Repeat repeat, const KnownFrames& known);
    // Those that step_from() will give one after the other, so many at most.
    std::vector<std::int64_t> next_ones(std::int64_t frame, Repeat repeat, const KnownFrames& known, std::size_t most) const;

private:
    bool plays_ = false;
    bool backward_ = false;
    Time last_{};
};

}  // namespace sphereview

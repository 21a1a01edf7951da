#include "viewer/play_clock.hpp"

#include <algorithm>

namespace sphereview {

void PlayClock::play(Time now) {
    plays_ = true;
    backward_ = false;
    last_ = now;
}

void PlayClock::shown(Beat beat, Time now) {
    const Time planned = due(beat);
    last_ = planned > now || now - planned > beat ? now : planned;
}

std::optional<std::int64_t> PlayClock::step_from(std::int64_t frame, Repeat repeat, const KnownFrames& known) {
    if (repeat != Repeat::back_and_forth) backward_ = false;
    if (backward_ && frame > 0) return frame - 1;
    backward_ = false;
    if (frame + 1 < known.frames) return frame + 1;
    if (!known.all || known.frames < 2 || repeat == Repeat::once) return std::nullopt;
    if (repeat == Repeat::loop) return 0;
    backward_ = true;
    return std::min(frame, known.frames) - 1;
}

std::vector<std::int64_t> PlayClock::next_ones(std::int64_t frame, Repeat repeat, const KnownFrames& known,
                                               std::size_t most) const {
    PlayClock ahead = *this;
    std::vector<std::int64_t> frames;
    for (auto next = ahead.step_from(frame, repeat, known); next && frames.size() < most;
         next = ahead.step_from(*next, repeat, known)) {
        frames.push_back(*next);
    }
    return frames;
}

}  // namespace sphereview

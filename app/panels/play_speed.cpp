#include "panels/timeline.hpp"

#include <algorithm>

#include "base/number.hpp"

namespace sphereview {

namespace {

// The one of ascending speeds behind `speed`, or before it; at the end the last one there.
template <typename Speeds>
double next_of(const Speeds& speeds, double speed, int by) {
    if (by > 0) {
        const auto above = std::ranges::upper_bound(speeds, speed);
        return above == speeds.end() ? speeds.back() : *above;
    }
    const auto at = std::ranges::lower_bound(speeds, speed);
    return at == speeds.begin() ? speeds.front() : *(at - 1);
}

}  // namespace

std::vector<double> recorded_speeds(double usual_step) {
    std::vector<double> speeds;
    const double fastest = usual_step * play_speeds.back();
    for (double speed = round_number_below(usual_step); speed > 0.0 && speed <= fastest;) {
        speeds.push_back(speed);
        constexpr double beyond_the_next = 2.6;  // 1, 2, 5, 10
        const double next = round_number_below(speed * beyond_the_next);
        if (next <= speed) break;
        speed = next;
    }
    return speeds;
}

PlaySpeed next_speed(const PlaySpeed& speed, std::optional<double> usual_step, int by) {
    PlaySpeed next = speed;
    if (!speed.recorded || !usual_step) {
        next.frames = next_of(play_speeds, speed.frames, by);
    } else if (const std::vector<double> speeds = recorded_speeds(*usual_step); !speeds.empty()) {
        next.recorded = next_of(speeds, *speed.recorded, by);
    }
    return next;
}

std::string words_of(const PlaySpeed& speed, const std::string& time_unit) {
    return (speed.recorded ? words_of_time(shortest(*speed.recorded), time_unit) : fixed(speed.frames, 0)) + " / s";
}

std::string words_of_time(const std::string& number, const std::string& unit) {
    return unit.empty() ? "t " + number : number + " " + unit;
}

}  // namespace sphereview

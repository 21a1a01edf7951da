// The speed of a playing film: frames a second, or the file's time a second.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sphereview {

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

}  // namespace sphereview

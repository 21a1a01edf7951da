// How fast a film plays: so many frames a second, or so much of the time that its frames have.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace sphereview

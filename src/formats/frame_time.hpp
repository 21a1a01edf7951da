// The time of a frame in its file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sphereview {

struct FrameTime {
    double value = 0.0;  // finite
    std::string text{};  // as in the file: "0.500"
    std::string unit{};  // "ps", "steps"; "" if unknown
};

// Nothing if `word` is not a finite number.
std::optional<FrameTime> frame_time(std::string_view word, std::string_view unit);

// The time in GROMACS's title "Water t= 0.50000 step= 250", in picoseconds.
std::optional<FrameTime> time_in_title(std::string_view title);

}  // namespace sphereview

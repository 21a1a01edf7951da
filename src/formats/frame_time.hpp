// When a frame is, as far as its file says so.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sphereview {

struct FrameTime {
    double value = 0.0;  // finite
    std::string text{};  // the same, as the file has it: "0.500"
    std::string unit{};  // "ps", "steps"; "" where nobody knows
};

// Nothing for a word that is no finite number.
std::optional<FrameTime> frame_time(std::string_view word, std::string_view unit);

// Of a title that GROMACS has written: "Water t=   0.50000 step= 250", in picoseconds.
std::optional<FrameTime> time_in_title(std::string_view title);

}  // namespace sphereview

// The options that say which pictures of a trajectory, or around a scene, are rendered.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "camera/turntable.hpp"

namespace sphereview {

// As a slice in Python: from `first` to before `last`, each `step`-th; negative numbers count from the end.
struct FrameRange {
    std::optional<std::int64_t> first{};
    std::optional<std::int64_t> last{};
    std::int64_t step = 1;
    bool is_single = false;  // `first` alone, which must exist

    bool operator==(const FrameRange&) const = default;
};

inline constexpr const char* frames_syntax = "all, N, A:B or A:B:STEP, with commas between; -1 is the last frame";

// Nothing for a text that is not of frames_syntax.
std::optional<std::vector<FrameRange>> parse_frames(std::string_view text);

// The numbers of the frames, in the order of the ranges. count(enough): how many frames the file has, `enough` at most. Throws
// InputError, which begins with the file's `name`, if a single frame does not exist or no frame is left.
std::vector<std::int64_t> frames_in(const std::vector<FrameRange>& ranges, const std::string& name,
                                    const std::function<std::int64_t(std::int64_t enough)>& count);

// One of `count` parts: every count-th picture, from the number-th on. `number` begins at 1.
struct RenderPart {
    std::int64_t number = 1;
    std::int64_t count = 1;

    bool has(std::size_t place) const { return static_cast<std::int64_t>(place) % count == number - 1; }
};

// Reads "2/4"; nothing for another text.
std::optional<RenderPart> parse_part_of_pictures(std::string_view text);

// The options of `render` for several pictures; the defaults mean one picture of --frame.
struct FrameOptions {
    std::vector<FrameRange> ranges{};
    bool fit_first = false;      // fits the camera to the first frame, not to all
    std::int64_t turntable = 0;  // pictures of a whole turn; 0: none
    TurnAxis axis = TurnAxis::up;
    bool skip_existing = false;             // pictures that are there whole
    std::optional<RenderPart> part{};       // of all pictures
    std::optional<std::string> manifest{};  // a file that gets a line for each picture

    // Whether pictures have numbers.
    bool several() const { return !ranges.empty() || turntable > 0; }
};

}  // namespace sphereview

#include "app/frame_ranges.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

// One number, or none between two colons.
bool parse_part(std::string_view text, std::optional<std::int64_t>& number) {
    return text.empty() || parse_whole(text, number.emplace());
}

std::optional<FrameRange> parse_range(std::string_view text) {
    if (text == "all") return FrameRange{};
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t colon = text.find(':');
        parts.push_back(text.substr(0, colon));
        if (colon == std::string_view::npos) break;
        text.remove_prefix(colon + 1);
    }
    FrameRange range;
    range.is_single = parts.size() == 1;
    if (parts.size() > 3 || (range.is_single && parts[0].empty())) return std::nullopt;
    if (!parse_part(parts[0], range.first)) return std::nullopt;
    if (parts.size() > 1 && !parse_part(parts[1], range.last)) return std::nullopt;
    if (parts.size() > 2) {
        std::optional<std::int64_t> step;
        if (!parse_part(parts[2], step) || step.value_or(1) < 1) return std::nullopt;
        range.step = step.value_or(1);
    }
    return range;
}

}  // namespace

std::optional<std::vector<FrameRange>> parse_frames(std::string_view text) {
    std::vector<FrameRange> ranges;
    while (true) {
        const std::size_t comma = text.find(',');
        const auto range = parse_range(text.substr(0, comma));
        if (!range) return std::nullopt;
        ranges.push_back(*range);
        if (comma == std::string_view::npos) return ranges;
        text.remove_prefix(comma + 1);
    }
}

std::optional<RenderPart> parse_part_of_pictures(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    std::optional<std::int64_t> number;
    std::optional<std::int64_t> count;
    if (!parse_part(text.substr(0, slash), number) || !parse_part(text.substr(slash + 1), count)) return std::nullopt;
    if (!number || !count || *number < 1 || *number > *count) return std::nullopt;
    return RenderPart{*number, *count};
}

std::vector<std::int64_t> frames_in(const std::vector<FrameRange>& ranges, const std::string& name,
                                    const std::function<std::int64_t(std::int64_t)>& count) {
    constexpr std::int64_t everything = std::int64_t{1} << 62;
    std::vector<std::int64_t> frames;
    for (const FrameRange& range : ranges) {
        const std::int64_t first = range.first.value_or(0);
        if (range.is_single) {
            const std::int64_t known = count(first < 0 || first >= everything ? everything : first + 1);
            if (first < -known || first >= known) require_frame(name, first, known);
            frames.push_back(first < 0 ? known + first : first);
            continue;
        }
        const bool has_end = range.last && *range.last >= 0 && first >= 0;
        const std::int64_t known = count(has_end ? *range.last : everything);
        const auto place = [known](std::int64_t number) {
            return std::clamp(number < 0 ? known + number : number, std::int64_t{0}, known);
        };
        const std::int64_t last = place(range.last.value_or(known));
        for (std::int64_t frame = place(first); frame < last; frame += std::min(range.step, known)) frames.push_back(frame);
    }
    if (frames.empty()) throw InputError(name + ": found no frame where --frames looks, expected one at least");
    return frames;
}

}  // namespace sphereview

#include "formats/frame_time.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

std::optional<FrameTime> frame_time(std::string_view word, std::string_view unit) {
    constexpr std::size_t longest_shown = 16;
    double value = 0.0;
    if (parse_any_double(word, value) != NumberFault::none) return std::nullopt;
    return FrameTime{value, word.size() <= longest_shown ? std::string(word) : shortest(value), std::string(unit)};
}

std::optional<FrameTime> time_in_title(std::string_view title) {
    constexpr std::string_view mark = "t=";
    constexpr std::size_t longest_title = 1 << 12;
    title = title.substr(0, longest_title);
    // The last one: what stands before it is the title that a person gave.
    for (std::size_t at = title.rfind(mark); at != std::string_view::npos; at = title.rfind(mark, at - 1)) {
        const bool is_word = at == 0 || is_space(title[at - 1]);
        std::string_view behind = title.substr(at + mark.size());
        behind.remove_prefix(std::min(behind.find_first_not_of(white_space), behind.size()));
        if (is_word) {
            if (auto time = frame_time(behind.substr(0, behind.find_first_of(white_space)), "ps")) return time;
        }
        if (at == 0) break;
    }
    return std::nullopt;
}

}  // namespace sphereview

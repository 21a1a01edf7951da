#include "app/film_options.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

std::optional<FrameRate> parse_frame_rate(std::string_view text) {
    constexpr std::size_t most = 1'000'000;
    const std::size_t slash = text.find('/');
    std::size_t pictures = 0;
    std::size_t seconds = 1;
    if (!parse_whole(text.substr(0, slash), pictures)) return std::nullopt;
    if (slash != std::string_view::npos && !parse_whole(text.substr(slash + 1), seconds)) return std::nullopt;
    if (pictures < 1 || pictures > most || seconds < 1 || seconds > most) return std::nullopt;
    return FrameRate{static_cast<int>(pictures), static_cast<int>(seconds)};
}

std::optional<FilmKind> film_kind(std::string_view path) {
    constexpr std::array<FilmKind, 5> kinds = {{{".mp4", true, false, 65'535},
                                                {".webm", true, false, 1000},
                                                {".gif", false, false, 50},
                                                {".png", false, true, 65'535},
                                                {".mkv", false, true, 1000}}};
    const auto found = std::ranges::find_if(kinds, [&](const FilmKind& kind) { return has_ending(path, kind.ending); });
    return found == kinds.end() ? std::nullopt : std::optional(*found);
}

std::string rates_instead_of(FrameRate rate, const FilmKind& kind) {
    constexpr int longest = 600;  // seconds that a picture stays: of .gif 655
    const auto pictures = std::int64_t{rate.pictures};
    const auto seconds = std::int64_t{rate.seconds};
    if (pictures <= kind.fastest * seconds && pictures * longest >= seconds) return "";
    return "1/" + std::to_string(longest) + " to " + std::to_string(kind.fastest) + " pictures a second of " +
           std::string(kind.ending);
}

}  // namespace sphereview

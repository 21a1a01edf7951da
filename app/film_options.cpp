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

std::span<const FilmKind> film_kinds() {
    static constexpr auto kinds = std::to_array<FilmKind>({
        {".mp4", "Film, H.264", "libx264", "-movflags +faststart -f mp4", 65'535, {}, 48, 40},
        {".webm", "Film, VP9", "libvpx-vp9", "-b:v 0 -row-mt 1 -f webm", 1000, {}, 63, 50},
        // A palette for each picture: one for all would keep all of them in memory first.
        {".gif", "Animated GIF", "gif", "-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1 -f gif", 50},
        {".png", "Animated PNG", "apng", "-plays 0 -f apng", 65'535, {"rgb24", "rgba"}, 0, 0, " (animated)"},
        {".mkv", "Lossless film, FFV1", "ffv1", "-level 3 -f matroska", 1000, {"bgr0", "bgra"}},
    });
    return kinds;
}

const FilmKind* film_kind(std::string_view path) {
    const auto found = std::ranges::find_if(film_kinds(), [&](const FilmKind& kind) { return has_ending(path, kind.ending); });
    return found == film_kinds().end() ? nullptr : &*found;
}

std::string film_endings(std::string_view last, bool with_quality) {
    std::vector<std::string> endings;
    for (const FilmKind& kind : film_kinds()) {
        if (kind.has_quality() || !with_quality) endings.push_back(std::string(kind.ending).append(kind.remark));
    }
    return listed(endings, last);
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

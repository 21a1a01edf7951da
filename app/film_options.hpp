// The options of a film.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "image/y4m.hpp"

namespace sphereview {

inline constexpr const char* film_endings = ".mp4, .webm, .gif, .png (animated) or .mkv";
inline constexpr int best_film_quality = 100;
inline constexpr int usual_film_quality = 75;

struct FilmOptions {
    std::optional<std::string> movie{};  // a file with one of film_endings
    FrameRate rate{};
    std::optional<int>
        quality{};  // 1 to best_film_quality, of .mp4 and .webm; the others lose nothing, or .gif what it cannot hold
};

// "30" or "30000/1001", each number from 1 to 1,000,000; nothing for another text.
std::optional<FrameRate> parse_frame_rate(std::string_view text);

// Whether a film may be called so, and whether its quality can be chosen, it may be transparent, and how fast it can be.
struct FilmKind {
    std::string_view ending;
    bool has_quality;
    bool has_alpha;
    int fastest;  // pictures a second: of .gif what players show in time, of the others what the file can say
};
std::optional<FilmKind> film_kind(std::string_view path);

// The rates that such a film can have, in words, if it cannot have this one; else "".
std::string rates_instead_of(FrameRate rate, const FilmKind& kind);

}  // namespace sphereview

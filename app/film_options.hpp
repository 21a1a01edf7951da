// The options of a film.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/y4m.hpp"

namespace sphereview {

inline constexpr int best_film_quality = 100;
inline constexpr int usual_film_quality = 75;

struct FilmOptions {
    std::optional<std::string> movie{};  // a file with the ending of one of film_kinds()
    FrameRate rate{};
    std::optional<int>
        quality{};  // 1 to best_film_quality, of .mp4 and .webm; the others lose nothing, or .gif what it cannot hold
};

// "30" or "30000/1001", each number from 1 to 1,000,000; nothing for another text.
std::optional<FrameRate> parse_frame_rate(std::string_view text);

// A kind of film, by its file's ending.
struct FilmKind {
    std::string_view ending;
    std::string_view title;    // in dialogs
    std::string_view encoder;  // ffmpeg's name of it
    std::string_view words;    // further arguments of ffmpeg, separated by blanks
    int fastest;               // pictures a second: of .gif what players show in time, of the others what the file can say
    std::array<std::string_view, 2> pixels{};  // ffmpeg's pixel formats without and with alpha; empty: never transparent
    int worst = 0;                             // ffmpeg's -crf at quality 0
    int range = 0;                             // how much less -crf is at best_film_quality; 0: no quality to choose
    std::string_view remark{};                 // behind the ending, in words

    bool has_quality() const { return range > 0; }
    bool has_alpha() const { return !pixels[0].empty(); }
};
std::span<const FilmKind> film_kinds();

// By the ending of the file's name, in any letter case; null for another.
const FilmKind* film_kind(std::string_view path);

// ".mp4 and .webm": of all kinds, or of those with a quality to choose.
std::string film_endings(std::string_view last, bool with_quality = false);

// The rates that such a film can have, in words, if it cannot have this one; else "".
std::string rates_instead_of(FrameRate rate, const FilmKind& kind);

}  // namespace sphereview

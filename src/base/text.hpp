// Small helpers for text that people read and write.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.hpp"

namespace sphereview {

// A place in a text file, counted from 1. Columns count characters (UTF-8 code points), as editors do.
struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;
};

// The place of byte `offset` in `text`, which begins at `origin`. Lines end with LF, CR or CR LF.
TextPosition position_at(std::string_view text, std::size_t offset, TextPosition origin = {});

// "NAME:LINE:COLUMN: ", the beginning of a message about a file.
std::string place_in(std::string_view name, TextPosition position);

// "found 'FOUND', expected EXPECTED", its end.
std::string found_expected(std::string_view found, std::string_view expected);

// `found` in single quotes, made safe for one terminal line: control and non-ASCII bytes as \xNN, at most 40 characters.
std::string in_quotes(std::string_view found);

// The first UTF-8 character of `text`, which must not be empty; of length 0 if there is none (RFC 3629).
struct Utf8Character {
    std::size_t length = 0;  // in bytes
    char32_t code = 0;
};
Utf8Character first_character(std::string_view text);

// Names of files on Windows are 16-bit units, usually UTF-16. A lone half of a surrogate pair becomes the three bytes that UTF-8
// would have for it (WTF-8), and so comes back unchanged.
std::string utf8_from(std::u16string_view units);
// The inverse; bytes that belong to no character become U+FFFD.
std::u16string utf16_from(std::string_view text);

// Text from outside, made safe to show: each byte of control characters, line separators, marks that reorder text, and of bytes
// that are not UTF-8 becomes \xNN. Longer texts are cut to `most` characters and "...".
std::string on_one_line(std::string_view text, std::size_t most = std::string_view::npos);
// The same, but line feeds stay.
std::string on_lines(std::string_view text, std::size_t most = std::string_view::npos);

// "; did you mean 'CANDIDATE'?" for the candidate most like `word`, ignoring case; "" if none is near enough.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

// "a; b; c", when `between` is "; ".
std::string joined(std::span<const std::string> words, std::string_view between);

// "a, b or c", when `last` is "or".
std::string listed(std::span<const std::string> words, std::string_view last);

// The first `most` words, and then "12 more" if there are more.
std::vector<std::string> first_of(std::vector<std::string> words, std::size_t most);

// The parts of a list with "or" that a person would type as they are: "auto, egl or #rrggbb" -> auto, egl.
std::vector<std::string> words_listed(std::string_view list);

// 1234567 as "1,234,567".
std::string in_groups(std::uint64_t value);

// "1 sphere", "1,234 spheres", when `what` is "sphere".
std::string counted(std::uint64_t count, std::string_view what);

// Removes the first line and its end (LF, CR or CR LF) from `text`, and returns the line.
std::string_view take_line(std::string_view& text);

// `text` without white space at both ends.
std::string_view trimmed(std::string_view text, std::string_view white = " \t\r\n");

// `text` without a UTF-8 byte-order mark, which some editors write first.
std::string_view without_byte_order_mark(std::string_view text);

// Whether `bytes` begin with a byte-order mark of UTF-16, of either order, or like Latin letters in UTF-16.
bool is_utf16(std::string_view bytes);

// `text` without the zero bytes and Ctrl-Z that some programs write at the end; UTF-16 stays unchanged.
std::string_view without_end_marks(std::string_view text);

// UTF-16 `bytes` as UTF-8, without a mark; U+FFFD for half a character.
std::string utf8_of_utf16(std::string_view bytes);

// `text` with each letter and following accent as one character, for letters of Latin-1 and Latin Extended-A: "e" and U+0301 as
// "é". Some systems store names of files in parts.
std::string composed(std::string_view text);

// `text` in lower case; ASCII letters only.
std::string lower_case(std::string_view text);

// Whether a file's name has the ending (".txt"), in any letter case.
bool has_ending(std::string_view name, std::string_view ending);

// The number of i in [begin, end) for which is(i) holds. If `is` reads bytes and does not branch, this becomes SIMD: sums of up to
// 255 fit in a byte.
template <typename Is>
std::size_t count_places(std::size_t begin, std::size_t end, const Is& is) {
    constexpr std::size_t stride = 255;
    std::size_t count = 0;
    while (begin < end) {
        const std::size_t stop = begin + std::min(stride, end - begin);
        std::uint8_t sum = 0;
        for (; begin < stop; ++begin) sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(is(begin)));
        count += sum;
    }
    return count;
}

}  // namespace sphereview

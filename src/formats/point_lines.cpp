#include "formats/point_lines.hpp"

#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "formats/csv_records.hpp"
#include "formats/csv_values.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

using Words = std::vector<std::string_view>;

// The words of the next line that holds any and is no comment; empty at the end.
Words next_words(std::string_view& text) {
    while (true) {
        text = trimmed(text, white_space);
        if (text.empty()) return {};
        const std::string_view line = take_line(text);
        if (comment_mark(line).empty()) return words_of(line);
    }
}

bool is_row_of_numbers(const Words& words) {
    const auto is_value = [](std::string_view word) { return is_number(word) || is_missing(word); };
    return words.size() >= 3 && std::all_of(words.begin(), words.begin() + 3, is_value);
}

bool begins_with_rows(std::string_view text) {
    constexpr int lines_looked_at = 3;
    Words first = next_words(text);
    // How many points follow, or atoms behind a comment, each of which begins with a symbol or an atomic number.
    const bool has_count = first.size() == 1 && is_digits(first[0]);
    if (has_count) first = next_words(text);
    if (!is_row_of_numbers(first)) return false;
    for (int line = 1; line < lines_looked_at; ++line) {
        const Words next = next_words(text);
        if (next.empty()) return line > 1 || !has_count;
        if (!is_row_of_numbers(next) || next.size() != first.size()) return false;
        if (has_count && next.size() > 3 && is_digits(next[0])) return false;
    }
    return true;
}

}  // namespace

bool shows_points(std::string_view head) {
    constexpr std::size_t enough = std::size_t{1} << 16;
    if (begins_with_rows(head)) return true;
    std::string_view rest = head;
    const Words first = next_words(rest);
    return !first.empty() && !is_digits(first[0]) && shows_csv(head.substr(0, enough));
}

}  // namespace sphereview

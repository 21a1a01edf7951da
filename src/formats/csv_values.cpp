#include "formats/csv_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::string_view no_break_space = "\xC2\xA0";
constexpr std::string_view minus_sign = "\xE2\x88\x92";

void replace_all(std::string& text, std::string_view found, std::string_view with) {
    for (std::size_t i = 0; (i = text.find(found, i)) != std::string::npos; i += with.size()) text.replace(i, found.size(), with);
}

// Removes the commas of 1,234,567.8; false where they stand elsewhere.
bool take_out_thousands(std::string& text) {
    const std::size_t first = text.find_first_not_of("+-");
    const std::size_t end = std::min(text.find('.'), text.size());
    const std::size_t comma = std::min(text.find(','), end);
    if (first == std::string::npos || comma <= first || comma > first + 3 || text[first] == '0') return false;
    if (text.find(',', end) != std::string::npos) return false;
    for (std::size_t i = first; i < end; ++i) {
        const bool is_comma_place = i >= comma && (i - comma) % 4 == 0;
        if (is_comma_place ? text[i] != ',' : text[i] < '0' || text[i] > '9') return false;
    }
    if ((end - comma) % 4 != 0) return false;
    std::erase(text, ',');
    return true;
}

}  // namespace

bool is_missing(std::string_view text) {
    if (text.empty()) return true;
    constexpr std::size_t longest = std::string_view("-1.#QNAN00").size();
    if (text.size() > longest) return false;
    const std::string word = lower_case(text);
    constexpr auto words = std::to_array<std::string_view>({"nan", "-nan", "+nan", "na",       "<na>",      "n/a",      "#n/a",
                                                            "#nv", "#na",  "nat",  "null",     "none",      "-",        "?",
                                                            "inf", "-inf", "+inf", "infinity", "-infinity", "-nan(ind)"});
    if (std::ranges::find(words, word) != words.end()) return true;
    // Microsoft's older C library: 1.#QNAN, -1.#IND00, 1.#INF.
    const std::size_t mark = word.find("1.#");
    return mark != std::string::npos && mark <= 1 && word.find_first_of("in", mark) != std::string::npos;
}

bool stands_for_none(std::string_view text, NumberFault fault) {
    return fault == NumberFault::not_finite || (fault == NumberFault::not_a_number && is_missing(text));
}

namespace {

// Fortran's 6.0+00 and 0.25-102 are numbers; 10.5-12 is rather a range.
NumberFault parse_unless_range(std::string_view text, double& value) {
    const std::size_t sign = text.find_last_of("+-");
    const bool may_be_range = text.find_first_of("eEdD*") == std::string_view::npos && sign != std::string_view::npos && sign > 0;
    const std::string_view digits = may_be_range ? text.substr(sign + 1) : "";
    const bool is_range = may_be_range && !digits.starts_with('0') && digits.size() < 3;
    return is_range ? parse_double(text, value) : parse_any_double(text, value);
}

}  // namespace

NumberFault parse_csv_number(std::string_view text, Commas commas, double& value) {
    const NumberFault fault = parse_unless_range(text, value);
    if (fault != NumberFault::not_a_number) return fault;
    std::string plain(text);
    replace_all(plain, no_break_space, "");
    replace_all(plain, minus_sign, "-");
    const std::size_t comma = plain.find(',');
    if (comma != std::string::npos && commas == Commas::decimal && plain.find('.') == std::string::npos) plain[comma] = '.';
    if (comma != std::string::npos && commas == Commas::thousands && !take_out_thousands(plain)) return fault;
    return plain == text ? fault : parse_unless_range(plain, value);
}

bool has_hex_mark(std::string_view text) { return text.starts_with('#') || text.starts_with("0x") || text.starts_with("0X"); }

std::optional<Color> parse_hex_color(std::string_view text) {
    const bool marked = has_hex_mark(text);
    if (marked) text.remove_prefix(text[0] == '#' ? 1 : 2);
    const bool is_short = marked && (text.size() == 3 || text.size() == 4);
    if (!is_short && text.size() != 6 && text.size() != 8) return std::nullopt;
    std::uint32_t code = 0;
    if (!parse_whole(text, code, 16)) return std::nullopt;
    if (text.size() == 8) code >>= 8;
    if (text.size() == 4) code >>= 4;
    const auto part = [code](int shift, std::uint32_t most) { return static_cast<std::uint8_t>((code >> shift) & most); };
    if (!is_short) return Color{part(16, 255), part(8, 255), part(0, 255)};
    return Color{static_cast<std::uint8_t>(17 * part(8, 15)), static_cast<std::uint8_t>(17 * part(4, 15)),
                 static_cast<std::uint8_t>(17 * part(0, 15))};
}

std::optional<Color> parse_packed_color(std::string_view text) {
    std::int64_t code = 0;
    if (!parse_whole(text, code) || code < INT32_MIN || code > UINT32_MAX) return std::nullopt;
    const auto part = [code](int shift) { return static_cast<std::uint8_t>((code >> shift) & 255); };
    return Color{part(16), part(8), part(0)};
}

namespace {

// Colours that are no part of 1 by so much are of 255. What is little more is one that was computed.
constexpr double most_of_one = 1.5;
constexpr double most_of_bytes = 4095.0;  // a wrong number among bytes is rarely larger, and colours of 16 bits rarely all smaller

}  // namespace

double full_color(double largest) {
    if (largest <= most_of_one) return 1.0;
    return largest <= most_of_bytes ? color_max : most_of_color;
}

std::optional<std::uint8_t> color_byte(double value, double full) {
    if (!(value >= 0.0 && value <= full * most_of_one)) return std::nullopt;
    return static_cast<std::uint8_t>(std::lround(color_max * std::min(1.0, value / full)));
}

std::optional<std::uint8_t> parse_color_byte(std::string_view text, double full, double& largest) {
    std::uint8_t whole = 0;
    if (parse_whole(text, whole)) {
        largest = std::max(largest, static_cast<double>(whole));
        return full == color_max ? whole : color_byte(whole, full).value_or(color_max);
    }
    constexpr double percent = 100.0;
    double value = 0.0;
    const bool is_part = text.ends_with('%');
    if (is_part && parse_csv_number(trimmed(text.substr(0, text.size() - 1)), Commas::decimal, value) == NumberFault::none)
        return color_byte(value, percent);
    if (has_hex_mark(text) && text[0] == '0') return parse_whole(text.substr(2), whole, 16) ? std::optional(whole) : std::nullopt;
    if (parse_csv_number(text, Commas::decimal, value) != NumberFault::none) return std::nullopt;
    if (value <= most_of_color) largest = std::max(largest, value);
    return color_byte(value, full);
}

}  // namespace sphereview

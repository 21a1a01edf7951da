// Values in the fields of tables, as programs write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/number.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// Whether a field holds no value: it is empty, or has a word for that ("nan", "NA", "#N/A").
bool is_missing(std::string_view text);

// Whether a field that failed to parse with `fault` means a missing value: is_missing(), or something else not finite, such as
// "nan(0x7)". A number beyond double's range is not missing.
bool stands_for_none(std::string_view text, NumberFault fault);

// What commas in numbers mean.
enum class Commas {
    none,
    decimal,   // 1,5 is 1.5
    thousands  // 1,234 is 1234
};

// Parses a table's number, also with the exponents of parse_any_double(), no-break spaces and Unicode's minus.
NumberFault parse_csv_number(std::string_view text, Commas commas, double& value);

// "#ff8000", "0xff8000", "#f80" or, with at least six digits, "ff8000", in any letter case. An alpha behind the colour is passed
// over.
std::optional<Color> parse_hex_color(std::string_view text);

// Whether the text has a mark that only a colour has: "#" or "0x".
bool has_hex_mark(std::string_view text);

// A colour as one whole number, 65536 r + 256 g + b, as PCL and Java write it. An alpha above it is passed over.
std::optional<Color> parse_packed_color(std::string_view text);

// What most likely stands for 255 in colours whose largest number is `largest`: 1, 255 or, in 16 bits, 65535.
double full_color(double largest);

// The largest number that a colour may have.
inline constexpr double most_of_color = 65535.0;

// A channel's number as a byte, where `full` stands for 255; nothing if the number is not a channel's or clearly above `full`.
std::optional<std::uint8_t> color_byte(double value, double full);

// A channel's field as a byte: a number such as 255 or 0.5, which may raise `largest`; also 100% and 0xff, which do not depend on
// `full`.
std::optional<std::uint8_t> parse_color_byte(std::string_view text, double full, double& largest);

}  // namespace sphereview

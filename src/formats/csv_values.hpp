// What the fields of tables hold, as programs write it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "base/number.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// Whether text is what stands in a field that holds nothing: nothing, or what programs write for it ("nan", "NA", "#N/A").
bool is_missing(std::string_view text);

// Whether text that is no number, by that fault, says that there is none: is_missing(), or what else is read as not finite, such as
// "nan(0x7)". A number beyond a double's range is not missing: the place that it stands for is unknown.
bool stands_for_none(std::string_view text, NumberFault fault);

// What commas in numbers are.
enum class Commas {
    none,
    decimal,   // 1,5 is one and a half
    thousands  // 1,234 is a thousand and more
};

// A number as tables have them, also with the exponents of parse_any_double(), no-break spaces and Unicode's minus.
NumberFault parse_csv_number(std::string_view text, Commas commas, double& value);

// "#ff8000", "0xff8000", "#f80" or, of at least six digits, "ff8000", in any letter case; what stands for alpha behind it is passed
// over.
std::optional<Color> parse_hex_color(std::string_view text);

// Whether only a colour is written so: with a mark before it.
bool has_hex_mark(std::string_view text);

// One whole number for red, green and blue, 65536 r + 256 g + b, as PCL and Java write it; what stands for alpha above is passed
// over.
std::optional<Color> parse_packed_color(std::string_view text);

// What stands for 255 in colours of which `largest` is the largest number, and of which no more is known: 1, 255 or, in 16 bits,
// 65535.
double full_color(double largest);

// No number of a colour is larger.
inline constexpr double most_of_color = 65535.0;

// A number of a colour as its byte; nothing for what is none, or clearly above `full`, which is what stands for 255.
std::optional<std::uint8_t> color_byte(double value, double full);

// A field of such a number as its byte: 255, or 0.5 and 65535, of which `largest` becomes the largest; also 100% and 0xff, which
// mean the same whatever `full` is.
std::optional<std::uint8_t> parse_color_byte(std::string_view text, double full, double& largest);

}  // namespace sphereview

#include "formats/csv_values.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>

#include "base/text.hpp"

namespace sphereview {

bool is_missing(std::string_view text) {
    if (text.empty()) return true;
    constexpr std::size_t longest = std::string_view("-nan(ind)").size();
    if (text.size() > longest) return false;
    const std::string word = lower_case(text);
    constexpr auto words =
        std::to_array<std::string_view>({"nan", "-nan", "+nan", "na", "n/a", "#n/a", "#nv", "#na", "null", "none", "-", "?", "inf",
                                         "-inf", "+inf", "infinity", "-infinity", "-nan(ind)"});
    return std::ranges::find(words, word) != words.end();
}

NumberFault parse_csv_number(std::string_view text, bool decimal_commas, double& value) {
    const NumberFault fault = parse_double(text, value);
    const std::size_t comma = text.find(',');
    if (fault != NumberFault::not_a_number || !decimal_commas || comma == std::string_view::npos) return fault;
    if (text.find('.') != std::string_view::npos) return fault;
    std::string with_point(text);
    with_point[comma] = '.';
    return parse_double(with_point, value);
}

std::optional<Color> parse_hex_color(std::string_view text) {
    if (text.starts_with('#')) {
        text.remove_prefix(1);
    } else if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
    }
    const bool is_short = text.size() == 3;
    if (!is_short && text.size() != 6 && text.size() != 8) return std::nullopt;
    std::uint32_t code = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), code, 16);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size()) return std::nullopt;
    if (text.size() == 8) code >>= 8;
    const auto part = [code](int shift, std::uint32_t most) { return static_cast<std::uint8_t>((code >> shift) & most); };
    if (!is_short) return Color{part(16, 255), part(8, 255), part(0, 255)};
    return Color{static_cast<std::uint8_t>(17 * part(8, 15)), static_cast<std::uint8_t>(17 * part(4, 15)),
                 static_cast<std::uint8_t>(17 * part(0, 15))};
}

}  // namespace sphereview

#include "look/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::size_t knots = 25;
using Knots = std::array<std::uint32_t, knots>;  // 0xRRGGBB, at equal distances

// Fitted, so that the curve through them is as near as can be to the colours that the authors published: viridis and plasma by
// N. Smith and S. van der Walt, cividis by J. Nunez, C. Anderton and R. Renslow, turbo by A. Mikhailov, coolwarm by K. Moreland.
constexpr std::array<Knots, 5> curves = {{
    {0x440154, 0x471163, 0x481F71, 0x472D7B, 0x443A83, 0x404688, 0x3B528B, 0x355D8D, 0x31688E,
     0x2C728E, 0x287C8E, 0x24868E, 0x21908C, 0x1F9A8A, 0x20A486, 0x28AE80, 0x35B779, 0x47C06F,
     0x5DC963, 0x75D054, 0x8FD744, 0xABDC32, 0xC7E020, 0xE3E418, 0xFDE724},
    {0x0E0787, 0x280592, 0x3A049A, 0x4C02A1, 0x5D01A6, 0x6E00A8, 0x7E03A8, 0x8D0BA4, 0x9C179E,
     0xA92396, 0xB52F8C, 0xC13B82, 0xCB4778, 0xD5536F, 0xDD5F65, 0xE66C5C, 0xED7953, 0xF3864A,
     0xF89441, 0xFBA338, 0xFDB32F, 0xFDC328, 0xFBD524, 0xF6E627, 0xF0F923},
    {0x00234D, 0x022A60, 0x003170, 0x1B386F, 0x2A406D, 0x38476C, 0x434E6C, 0x4D566C, 0x575D6D,
     0x61656F, 0x6A6C71, 0x737475, 0x7C7B78, 0x868378, 0x908B78, 0x9B9376, 0xA59C74, 0xB0A471,
     0xBBAD6D, 0xC6B667, 0xD1BF61, 0xDDC857, 0xE8D351, 0xF6DC3D, 0xFFE735},
    {0x31123C, 0x3C3184, 0x434FBB, 0x466BE3, 0x4686FA, 0x3BA1FD, 0x29BBEC, 0x1AD2D1, 0x1AE4B6,
     0x31F299, 0x56FB75, 0x80FF54, 0xA3FD3C, 0xBEF434, 0xD8E436, 0xEDD03A, 0xFABA39, 0xFEA02F,
     0xFB8022, 0xF26014, 0xE4460A, 0xD23105, 0xBA1F02, 0x9D1001, 0x7B0403},
    {0x3B4CC0, 0x475FD0, 0x5471DE, 0x6282EA, 0x7092F3, 0x7EA2FA, 0x8DB0FE, 0x9CBCFF, 0xAAC7FD,
     0xB8CFF9, 0xC5D6F2, 0xD2DAE8, 0xDDDCDD, 0xE7D7CD, 0xEFCFBD, 0xF4C4AD, 0xF7B89C, 0xF7AA8B,
     0xF49A7B, 0xEF886B, 0xE7755B, 0xDE614D, 0xD2493F, 0xC43032, 0xB40526},
}};

std::uint8_t byte_of(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

// Catmull and Rom's curve through the knots, which goes straight on beyond the first and the last.
std::uint8_t on_curve(const Knots& curve, int shift, std::size_t knot, double u) {
    const auto at = [&](std::size_t i) { return static_cast<double>((curve[i] >> shift) & 255U); };
    const double p1 = at(knot);
    const double p2 = at(knot + 1);
    const double p0 = knot == 0 ? 2.0 * p1 - p2 : at(knot - 1);
    const double p3 = knot + 2 == knots ? 2.0 * p2 - p1 : at(knot + 2);
    const double cubic = 1.5 * (p1 - p2) + 0.5 * (p3 - p0);
    const double squared = p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3;
    return byte_of(p1 + u * (0.5 * (p2 - p0) + u * (squared + u * cubic)));
}

// A colour mixed with a grey `level`; `percent`: the colour's part.
Color mixed(const Color& color, int percent, int level) {
    const auto part = [&](std::uint8_t own) {
        return static_cast<std::uint8_t>((own * percent + level * (100 - percent) + 50) / 100);
    };
    return {part(color.r), part(color.g), part(color.b)};
}

}  // namespace

std::optional<ColorMap> color_map_named(std::string_view name) {
    const auto found = std::ranges::find(color_map_names, name);
    return found == color_map_names.end() ? std::nullopt : std::optional(static_cast<ColorMap>(found - color_map_names.begin()));
}

std::string color_map_syntax() { return listed(std::vector<std::string>(color_map_names.begin(), color_map_names.end()), "or"); }

Color color_of(ColorMap map, double part) {
    const double place = std::clamp(part, 0.0, 1.0);
    if (map == ColorMap::grey) {
        const std::uint8_t level = byte_of(255.0 * place);
        return {level, level, level};
    }
    const Knots& curve = curves[static_cast<std::size_t>(map)];
    const double along = place * (knots - 1);
    const std::size_t knot = std::min(static_cast<std::size_t>(along), knots - 2);
    const double u = along - static_cast<double>(knot);
    return {on_curve(curve, 16, knot, u), on_curve(curve, 8, knot, u), on_curve(curve, 0, knot, u)};
}

Color category_color(std::size_t category) {
    constexpr std::array<Color, 7> first = {
        {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {213, 94, 0}, {204, 121, 167}}};
    struct Variation {
        int percent;
        int level;
    };
    constexpr std::array<Variation, 5> variations = {{{100, 0}, {50, 255}, {60, 0}, {25, 255}, {35, 0}}};
    static_assert(first.size() * variations.size() == category_colors);
    const Variation& how = variations[category / first.size() % variations.size()];
    return mixed(first[category % first.size()], how.percent, how.level);
}

}  // namespace sphereview

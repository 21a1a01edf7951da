// Colours that stand for numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "scene/sphere.hpp"

namespace sphereview {

enum class ColorMap { viridis, plasma, cividis, turbo, coolwarm, grey };

// By their values.
inline constexpr std::array<std::string_view, 6> color_map_names = {"viridis", "plasma", "cividis", "turbo", "coolwarm", "grey"};

constexpr std::string_view name_of(ColorMap map) { return color_map_names[static_cast<std::size_t>(map)]; }
std::optional<ColorMap> color_map_named(std::string_view name);

// "viridis, plasma, cividis, turbo, coolwarm or grey".
std::string color_map_syntax();

// Of a part from 0 to 1; what is beyond becomes the nearer end. Each of red, green and blue is within 3 of what the map's authors
// published. The same on every machine: doubles made by + - * / in a fixed order.
Color color_of(ColorMap map, double part);

// Of the spheres that have no value.
inline constexpr Color no_value_color{128, 128, 128};

// The colour of the n-th category. The first 7 are those of M. Okabe and K. Ito, "Color Universal Design", which people with any
// kind of colour-blindness can tell apart, without black; then come lighter and darker ones of the same seven, 35 in all, and then
// the first again.
Color category_color(std::size_t category);
inline constexpr std::size_t category_colors = 35;

}  // namespace sphereview

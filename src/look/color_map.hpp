// Colours for numbers and categories.
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

// The map's colour at `part`, 0 to 1; parts beyond get the nearer end. Red, green and blue are within 3 of the published map. The
// same on every machine: doubles made by + - * / in a fixed order.
Color color_of(ColorMap map, double part);

// The colour of spheres without a value.
inline constexpr Color no_value_color{128, 128, 128};

// The colour of the n-th category: first the 7 colours without black of M. Okabe and K. Ito, "Color Universal Design", which people
// with any colour-blindness can tell apart; then lighter and darker ones of these, 35 in all; then the first again.
Color category_color(std::size_t category);
inline constexpr std::size_t category_colors = 35;

}  // namespace sphereview

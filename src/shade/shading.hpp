// The ways in which a picture can be coloured. docs/shading.md has the formulae.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sphereview {

enum class Shading { flat, headlight, normal, depth, id };

// By their values.
inline constexpr std::array<std::string_view, 5> shading_names = {"flat", "headlight", "normal", "depth", "id"};
inline constexpr std::string_view shading_syntax = "flat, headlight, normal, depth or id";

constexpr std::string_view name_of(Shading shading) { return shading_names[static_cast<std::size_t>(shading)]; }

constexpr std::optional<Shading> shading_named(std::string_view name) {
    for (std::size_t i = 0; i < shading_names.size(); ++i) {
        if (shading_names[i] == name) return static_cast<Shading>(i);
    }
    return std::nullopt;
}

// Whether a colour depends on where the ray hits, not on the sphere alone.
constexpr bool depends_on_hit(Shading shading) {
    return shading == Shading::headlight || shading == Shading::normal || shading == Shading::depth;
}

}  // namespace sphereview

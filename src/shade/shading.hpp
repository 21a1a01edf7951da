// The ways in which a picture can be coloured: one table for the command line, the menus, the settings and the shaders. A new one
// is a name and a row here, and its formula twice: in picture_shader.cpp and in shaders/surface.frag, or in gpu/scene_tables.cpp if
// it does not depend on the hit. docs/shading.md has the formulae.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/sphere.hpp"

namespace sphereview {

enum class Shading { flat, headlight, normal, depth, id, studio };

struct ShadingMode {
    std::string_view name;   // on the command line and in reports
    std::string_view title;  // in the menu
    std::string_view help;   // one sentence
    bool depends_on_hit;     // on where the ray hits, not on the sphere alone
    bool is_lit = false;     // by the lights of the scene, with their shadows
};

// By their values.
inline constexpr std::array<ShadingMode, 6> shading_modes = {{
    {"flat", "Flat", "Shading: the spheres' own colours.", false},
    {"headlight", "Headlight", "Shading: light from the eye, dimmer with distance.", true},
    {"normal", "Normals", "Shading: the direction that the surface faces, as a colour.", true},
    {"depth", "Depth", "Shading: the distance from the eye, from white to dark grey.", true},
    {"id", "False colours", "Shading: a colour for each sphere that tells it from the others.", false},
    {"studio", "Studio", "Shading: sky, key light and sun, with their shadows.", true, true},
}};

constexpr std::string_view name_of(Shading shading) { return shading_modes[static_cast<std::size_t>(shading)].name; }

constexpr bool depends_on_hit(Shading shading) { return shading_modes[static_cast<std::size_t>(shading)].depends_on_hit; }

constexpr bool is_lit(Shading shading) { return shading_modes[static_cast<std::size_t>(shading)].is_lit; }

constexpr std::optional<Shading> shading_named(std::string_view name) {
    for (std::size_t i = 0; i < shading_modes.size(); ++i) {
        if (shading_modes[i].name == name) return static_cast<Shading>(i);
    }
    return std::nullopt;
}

// "flat, headlight, normal, depth, id or studio".
inline std::string shading_syntax() {
    std::string names;
    for (const ShadingMode& mode : shading_modes) {
        names += &mode == &shading_modes.front() ? "" : &mode == &shading_modes.back() ? " or " : ", ";
        names += mode.name;
    }
    return names;
}

// The false colour that tells the sphere of that number in the file from others. Integers only. Consecutive numbers are a golden
// section of the circle of hues apart; brightness and saturation differ too. No channel is below 30: no sphere is as dark as a
// black background.
constexpr Color id_color(std::uint32_t number) {
    const std::uint32_t around = number * 2654435769U;  // 2^32 / golden ratio
    const std::uint32_t hue = (around >> 16) * 6;       // 65,536 to each sixth of the circle
    const std::uint32_t mixed = (number ^ (number >> 7)) * 2246822519U;
    const std::uint32_t high = 255 - 45 * ((mixed >> 20) % 3);  // 255, 210, 165
    const std::uint32_t low = (mixed >> 24) % 2 == 0 ? 30 : 85;
    const std::uint32_t part = ((hue & 65535U) * (high - low)) >> 16;
    const auto h = static_cast<std::uint8_t>(high);
    const auto l = static_cast<std::uint8_t>(low);
    const auto up = static_cast<std::uint8_t>(low + part);
    const auto down = static_cast<std::uint8_t>(high - part);
    switch (hue >> 16) {
        case 0: return {h, up, l};
        case 1: return {down, h, l};
        case 2: return {l, h, up};
        case 3: return {l, down, h};
        case 4: return {up, l, h};
        default: return {h, l, down};
    }
}

}  // namespace sphereview

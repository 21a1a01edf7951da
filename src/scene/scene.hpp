// What is drawn.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

// What a pixel shows where no sphere is. A transparent one makes the picture RGBA.
struct Background {
    Color color{0, 0, 0};
    bool transparent = false;

    bool operator==(const Background&) const = default;
};

// How a background is written, for messages and help.
inline constexpr std::string_view background_syntax = "black, white, transparent or #rrggbb";

// Reads what background_syntax says. Returns false, and leaves `background` alone, for anything else.
bool parse_background(std::string_view text, Background& background);

// The shortest spelling that parse_background reads back as the same.
std::string to_string(const Background& background);

// The most spheres a scene may have: their numbers, and the marks for doubtful pixels, share a signed 32-bit integer.
inline constexpr std::int64_t most_spheres = 2'000'000'000;

// Spheres are numbered from 0 in file order; of two equal hits the lower number is seen.
struct Scene {
    std::vector<Sphere> spheres;
    std::map<std::uint32_t, std::string> names;  // only of the spheres that have one
    Background background;
    Camera camera;

    bool operator==(const Scene&) const = default;
};

}  // namespace sphereview

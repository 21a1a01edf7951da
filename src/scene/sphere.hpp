// One sphere of a scene.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace sphereview {

// A flat 8-bit colour; the PNG holds the file's bytes.
struct Color {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    bool operator==(const Color&) const = default;
};

inline constexpr int color_max = 255;

// "255 0 0", as the text format has it.
inline std::string in_words(const Color& color) {
    return std::to_string(color.r) + " " + std::to_string(color.g) + " " + std::to_string(color.b);
}

// In scene space: +x right, +y up, +z into the picture. The doubles are the scene: nothing rounds them.
struct Sphere {
    glm::dvec3 center{0.0, 0.0, 200.0};  // finite
    double radius = 20.0;                // finite, > 0
    Color color{255, 255, 255};
    bool hidden = false;  // kept, but not drawn

    bool operator==(const Sphere&) const = default;
};

static_assert(sizeof(Sphere) == 40, "a million spheres should stay small");

}  // namespace sphereview

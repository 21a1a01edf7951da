// Lines, dots and letters over a picture, in whole numbers: the same bytes everywhere. Places and widths are in sixteenths of a
// pixel, (0, 0) being the picture's top left corner.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace sphereview {

inline constexpr int stroke_unit = 16;  // of a pixel

struct StrokePlace {
    int x = 0;
    int y = 0;
};

// A line with round ends, at most as long as a picture's side; a dot if both ends are the same.
struct Stroke {
    StrokePlace from;
    StrokePlace to;
    int width = stroke_unit;
    std::array<std::uint8_t, 3> color{255, 255, 255};
};

// Draws the strokes one over the other. A pixel takes the colour in proportion to its covered 4 x 4 points, halves rounded up.
// Covered pixels become opaque.
void draw(std::span<const Stroke> strokes, Image& picture);

// Letters of printable ASCII from their top left corner, without other characters: capitals are 7 `unit`s high, lines `width` wide.
std::vector<Stroke> strokes_of_text(std::string_view text, StrokePlace corner, int unit, int width,
                                    const std::array<std::uint8_t, 3>& color);
// The width of the text between its outer edges, in sixteenths of a pixel.
int width_of_strokes(std::string_view text, int unit);
inline constexpr int height_of_letters = 7;  // in units

}  // namespace sphereview

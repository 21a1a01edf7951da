// The buffer between visibility and shading: the number of the visible sphere for each pixel.
#pragma once

#include <cstdint>

namespace sphereview {

// What a pixel shows: the number of a sphere, or this. Twin: shaders/visible.glsl.
inline constexpr std::int32_t visible_background = -1;

// A rectangle of a picture's pixels; (x, y) is its top left one.
struct Block {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

}  // namespace sphereview

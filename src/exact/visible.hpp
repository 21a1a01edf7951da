// The buffer between visibility and shading: for each pixel the number of the visible sphere. Twin: shaders/visible.glsl.
#pragma once

#include <cstdint>

namespace sphereview {

// What a pixel shows: the number of a sphere (0 and up), the background, or a doubtful guess: float could not tell.
inline constexpr std::int32_t visible_background = -1;
inline constexpr std::int32_t doubtful_background = -2;    // perhaps nothing
inline constexpr std::int32_t first_doubtful_sphere = -3;  // perhaps sphere 0; -4: perhaps sphere 1; ...

constexpr bool is_doubtful(std::int32_t visible) { return visible <= doubtful_background; }

// The doubtful form of a guess (a number or visible_background); its own inverse.
constexpr std::int32_t doubtful(std::int32_t guess) { return first_doubtful_sphere - guess; }

static_assert(doubtful(visible_background) == doubtful_background && doubtful(0) == first_doubtful_sphere);
static_assert(doubtful(doubtful(7)) == 7 && doubtful(doubtful_background) == visible_background);

// A rectangle of a picture's pixels; (x, y) is its top left one.
struct Block {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

}  // namespace sphereview

// What a window shows where no sphere is.
#include "draw.glsl"

vec4 background_at(ivec2 pixel) {
    if (background.a > 0.0 || checkerboard == 0) return background;
    ivec2 square = pixel >> checkerboard;
    return ((square.x + square.y) & 1) == 0 ? vec4(0.6, 0.6, 0.6, 1.0) : vec4(0.4, 0.4, 0.4, 1.0);
}

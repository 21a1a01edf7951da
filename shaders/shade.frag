#version 330 core
// Turns the visible-sphere buffer into flat colours, for a window.
#include "colors.glsl"
#include "visible.glsl"
#include "window.glsl"

uniform isampler2D visible_spheres;

out vec4 color;

vec4 background_at(ivec2 pixel) {
    if (background.a > 0.0 || checkerboard == 0) return background;
    ivec2 square = pixel >> checkerboard;
    return ((square.x + square.y) & 1) == 0 ? vec4(0.6, 0.6, 0.6, 1.0) : vec4(0.4, 0.4, 0.4, 1.0);
}

void main() {
    ivec2 pixel = window_pixel();
    int number = best_guess(texelFetch(visible_spheres, texel_of(pixel), 0).r);  // a window has no holes
    color = number > visible_background ? vec4(color_at(number).rgb, 1.0) : background_at(pixel);
}

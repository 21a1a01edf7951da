#version 330 core
// Turns the visible-sphere buffer into flat colours, or false ones for each sphere, for a window.
#include "background.glsl"
#include "colors.glsl"
#include "visible.glsl"
#include "window.glsl"

uniform isampler2D visible_spheres;

out vec4 color;

void main() {
    ivec2 pixel = window_pixel();
    int number = best_guess(texelFetch(visible_spheres, texel_of(pixel), 0).r);  // a window has no holes
    color = number > visible_background ? vec4(color_at(number).rgb, 1.0) : background_at(pixel);
}

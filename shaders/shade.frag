#version 330 core
// Turns the visible-sphere buffer into flat colours, or false ones for each sphere, for a window.
#include "background.glsl"
#include "colors.glsl"
#include "seen.glsl"

out vec4 color;

void main() {
    ivec2 pixel = window_pixel();
    int index = seen_at(pixel);
    color = index > visible_background ? vec4(color_at(index).rgb, 1.0) : background_at(pixel);
}

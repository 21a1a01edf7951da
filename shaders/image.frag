#version 330 core
// Shows a finished picture in a window.
#include "background.glsl"
#include "window.glsl"

uniform sampler2D image;

out vec4 color;

void main() {
    ivec2 pixel = window_pixel();
    vec4 seen = texelFetch(image, clamp(pixel, ivec2(0), picture_size - 1), 0);
    color = vec4(mix(background_at(pixel).rgb, seen.rgb, seen.a), 1.0);
}

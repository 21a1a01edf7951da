#version 330 core
// The average of each pixel's points, for a window: of bytes, halves rounded up. Twin: src/image/average.hpp.
#include "window.glsl"

uniform sampler2D sums;  // of the points' colours, each 0..1; the window's bottom row first
uniform int samples;     // a power of two: nothing below is rounded unseen

out vec4 color;

void main() {
    ivec2 pixel = clamp(window_pixel(), ivec2(0), picture_size - 1);
    vec3 sum = texelFetch(sums, ivec2(pixel.x, picture_size.y - 1 - pixel.y), 0).rgb;
    vec3 bytes = floor(255.0 * sum + 0.5);
    color = vec4(floor(bytes / float(samples) + 0.5) / 255.0, 1.0);
}

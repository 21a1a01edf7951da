#version 330 core
// Turns the visible-sphere buffer into flat colours, for a window: the buffer's top row becomes the viewport's top row.
#include "colors.glsl"
#include "frame.glsl"
#include "visible.glsl"

uniform isampler2D visible_spheres;

out vec4 color;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int number = texelFetch(visible_spheres, ivec2(at.x, picture_size.y - 1 - at.y), 0).r;
    if (number < visible_background) number = doubtful(number);  // the best guess: a window has no holes
    color = number > visible_background ? color_at(number) : background;
}

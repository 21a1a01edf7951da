#version 330 core
// Picks the spheres that have an outline from the visible-sphere buffer, so that outline.frag need look only once a pixel.
#include "colors.glsl"
#include "marks.glsl"
#include "visible.glsl"

uniform isampler2D visible_spheres;

out int mark;

void main() {
    int number = best_guess(texelFetch(visible_spheres, ivec2(gl_FragCoord.xy), 0).r);
    bool selected = number > visible_background && color_at(max(number, 0)).a > 0.0;
    bool under_pointer = number > visible_background && number == hovered;
    mark = selected ? number : under_pointer ? hovered_mark : no_mark;
}

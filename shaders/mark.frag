#version 330 core
// Picks the pixels of spheres that have an outline, so that outline.frag need look only once a pixel.
#include "colors.glsl"
#include "marks.glsl"
#include "seen.glsl"

out int mark;

void main() {
    int index = seen_at(ivec2(gl_FragCoord.xy));
    float selected = index > visible_background ? color_at(max(index, 0)).a : 0.0;
    bool under_pointer = index > visible_background && index == hovered;
    if (selected > alone) {
        mark = index;
    } else if (selected > 0.0) {
        mark = under_pointer ? hovered_set_mark : set_mark;
    } else {
        mark = under_pointer ? hovered_mark : no_mark;
    }
}

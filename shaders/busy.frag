#version 330 core
// Finds the cells within reach of which two marks differ. In the others, most of a picture, outline.frag need not look around.
#include "marks.glsl"

uniform isampler2D marks;

out int busy;

void main() {
    int reach = outline_reach() + 1;
    ivec2 cell = ivec2(gl_FragCoord.xy) << cell_shift;
    ivec2 first = max(cell - reach, 0);
    ivec2 last = min(cell + (1 << cell_shift) - 1 + reach, picture_size - 1);
    int mark = texelFetch(marks, first, 0).r;
    bool calm = true;
    for (int y = first.y; calm && y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) calm = calm && texelFetch(marks, ivec2(x, y), 0).r == mark;
    }
    busy = calm ? 0 : 1;
}

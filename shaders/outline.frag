#version 330 core
// Outlines around spheres, over the picture in a window: a light line beside the sphere's pixels, which keep their colours, between
// two dark ones, so that something shows on any colour.
#include "marks.glsl"
#include "window.glsl"

uniform isampler2D marks;
uniform isampler2D busy_cells;

out vec4 color;

const float far = 1.0e6;

void main() {
    ivec2 pixel = window_pixel();
    ivec2 texel = texel_of(pixel);
    int own = texelFetch(marks, texel, 0).r;
    // The squared distances to the nearest pixels of other spheres that are marked.
    float selected = far;
    float under_pointer = far;
    int reach = outline_reach();
    int end = texelFetch(busy_cells, texel >> cell_shift, 0).r != 0 ? reach : -reach - 1;
    for (int y = -reach; y <= end; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            int mark = texelFetch(marks, texel_of(pixel + ivec2(x, y)), 0).r;
            float distance = mark == own || mark == no_mark ? far : float(x * x + y * y);
            bool is_hovered = mark == hovered_mark || mark == hovered;
            selected = min(selected, mark == hovered_mark ? far : distance);
            under_pointer = min(under_pointer, is_hovered ? distance : far);
        }
    }
    // Half a pixel more: the distances are those of pixels' centres.
    const float inner = 1.5;
    float wide = inner + outline;
    float thin = inner + max(0.5 * outline, 1.0);
    float to_selected = sqrt(selected);
    float to_hovered = sqrt(under_pointer);
    bool dark = min(to_selected, to_hovered) < inner;
    if (!dark && to_hovered < thin) {
        color = vec4(1.0, 1.0, 1.0, 1.0);
    } else if (!dark && to_selected < wide) {
        color = vec4(1.0, 0.65, 0.0, 1.0);
    } else if (dark || to_hovered < thin + 1.0 || to_selected < wide + 1.0) {
        color = vec4(0.0, 0.0, 0.0, 0.7);
    } else {
        discard;
    }
}

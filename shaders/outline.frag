#version 330 core
// Outlines around spheres, over the picture in a window: a light line beside the sphere's pixels, which keep their colours, between
// two dark ones, so that something shows on any colour. Spheres that are outlined as one set are tinted, and between them is no line.
#include "marks.glsl"
#include "window.glsl"

uniform isampler2D marks;
uniform isampler2D busy_cells;

out vec4 color;

const float far = 1.0e6;

// The squared distances to the nearest pixels of other spheres that are marked.
float selected = far;
float under_pointer = far;

// Among the pixels so many columns and rows away or less.
void look_around(ivec2 pixel, int own, int reach) {
    ivec2 first = max(pixel - reach, ivec2(0));
    ivec2 last = min(pixel + reach, picture_size - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            int mark = texelFetch(marks, ivec2(x, y), 0).r;
            vec2 away = vec2(pixel - ivec2(x, y));
            float distance = mark == own || mark == no_mark ? far : dot(away, away);
            bool is_hovered = mark == hovered_mark || mark == hovered_set_mark || mark == hovered;
            bool has_no_line = mark == hovered_mark || (is_of_set(mark) && is_of_set(own));
            selected = min(selected, has_no_line ? far : distance);
            under_pointer = min(under_pointer, is_hovered ? distance : far);
        }
    }
}

void main() {
    ivec2 pixel = window_pixel();
    ivec2 at = clamp(pixel, ivec2(0), picture_size - 1);
    int own = texelFetch(marks, at, 0).r;
    bool calm = texelFetch(busy_cells, at >> cell_shift, 0).r == 0;
    if (calm && !is_of_set(own)) discard;
    // Where many small spheres are selected most pixels are beside another one: then nothing more has to be known.
    if (!calm) look_around(pixel, own, 1);
    if (!calm && min(selected, under_pointer) > 2.0) look_around(pixel, own, outline_reach());
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
    } else if (is_of_set(own)) {
        color = vec4(1.0, 0.65, 0.0, 0.3);
    } else {
        discard;
    }
}

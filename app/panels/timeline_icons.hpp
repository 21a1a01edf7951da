// The icons on the buttons of the line of time.
#pragma once

#include <imgui.h>

#include "panels/timeline.hpp"

namespace sphereview {

// The place of an icon on a button.
struct IconPlace {
    ImVec2 middle;
    float size;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {middle.x + x * size, middle.y + y * size}; }
};

// `tip` and `back`: places across, in sizes from the middle.
void draw_triangle(const IconPlace& icon, float tip, float back);
// An upright bar from `left` to `right`, in sizes from the middle.
void draw_bar(const IconPlace& icon, float left, float right);
// What comes behind the last frame.
void draw_repeat(const IconPlace& icon, Repeat repeat);

}  // namespace sphereview

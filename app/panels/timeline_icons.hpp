// What the buttons of the line of time show.
#pragma once

#include <imgui.h>

#include "panels/timeline.hpp"

namespace sphereview {

// What stands on a button, about its middle, so large.
struct IconPlace {
    ImVec2 middle;
    float size;
    ImU32 color;

    ImVec2 at(float x, float y) const { return {middle.x + x * size, middle.y + y * size}; }
};

// Its tip and its back stand at such places across, in sizes from the middle.
void draw_triangle(const IconPlace& icon, float tip, float back);
// Upright, from such a place across to another.
void draw_bar(const IconPlace& icon, float left, float right);
// What comes behind the last frame.
void draw_repeat(const IconPlace& icon, Repeat repeat);

}  // namespace sphereview

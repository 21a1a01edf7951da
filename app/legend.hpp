// The legend of a picture's colours, drawn over it: a bar of colours with numbers, or a dot, name and count for each category. The
// window draws the same lines.
#pragma once

#include <vector>

#include "image/strokes.hpp"
#include "look/coloring.hpp"

namespace sphereview {

// The room of a legend, in sixteenths of a pixel. `corner`: the upper right one.
struct LegendRoom {
    StrokePlace corner;
    int width = 0;
    int height = 0;
};

// The room in a picture of that size, in sixteenths of a pixel, with marks of that unit: in the upper right corner, beside the axes
// and above the scale bar.
LegendRoom room_for_legend(int width, int height, int unit);

// Letters are drawn in 1.5 `unit`s, or in one `unit` if there are many categories. Categories that do not fit are counted in a last
// line: "and 12 more". Long names are cut. `on_light`: dark letters, for a light background.
std::vector<Stroke> strokes_of_legend(const Coloring& coloring, const LegendRoom& room, int unit, bool on_light);

}  // namespace sphereview

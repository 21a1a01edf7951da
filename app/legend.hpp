// What the colours of a picture stand for, drawn over it: a bar of colours with numbers, or a dot for each category with its name
// and count. A window draws the same lines.
#pragma once

#include <vector>

#include "image/strokes.hpp"
#include "look/coloring.hpp"

namespace sphereview {

// Where a legend may be, in sixteenths of a pixel: it hangs from its upper right corner.
struct LegendRoom {
    StrokePlace corner;
    int width = 0;
    int height = 0;
};

// Of a picture of that size, in sixteenths of a pixel, with marks of that unit: the upper right corner, beside the axes and above
// the scale bar.
LegendRoom room_for_legend(int width, int height, int unit);

// Letters are a half larger than `unit`s, or, where there are too many categories for that, as large. What does not fit then is
// counted in a last line: "and 12 more". Long names are cut. `on_light`: dark letters, for a light background.
std::vector<Stroke> strokes_of_legend(const Coloring& coloring, const LegendRoom& room, int unit, bool on_light);

}  // namespace sphereview

// Giving a sphere another place in the list by dragging its row.
#pragma once

#include <cstddef>

#include "panels/side_panel.hpp"
#include "panels/sphere_filter.hpp"

namespace sphereview {

// Where rows are, in screen coordinates. In double: ImGui's float cursor has no pixels left behind a million rows.
struct RowPlaces {
    double top;  // of row 0
    float left;
    float width;
    float height;  // of a row

    float of(std::size_t row) const { return static_cast<float>(top + static_cast<double>(row) * height); }
    // The row that is nearest to y with its upper edge, 0..rows.
    std::size_t gap_at(float y, std::size_t rows) const;
};

// Draws a line where the sphere that is being dragged would go, and lets it go there. Escape leaves it where it is.
void drag_row(const PanelContext& context, SidePanelState& state, const ListedSpheres& listed, const RowPlaces& places);

}  // namespace sphereview

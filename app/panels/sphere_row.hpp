// One row of the list of spheres: whether it is shown, colour, title, radius.
#pragma once

#include <imgui.h>

#include "panels/side_panel.hpp"

namespace sphereview {

// What was done with a row.
struct RowResult {
    bool eye = false;             // pressed
    bool pressed = false;         // left button, elsewhere
    bool double_clicked = false;  // likewise
    bool menu = false;            // right button
    bool dragging = false;        // the row is held and was moved
};

// At a place in screen coordinates. Draws the field for the name instead of the title while the sphere is renamed.
RowResult draw_sphere_row(const PanelContext& context, SidePanelState& state, std::uint32_t number, ImVec2 place, ImVec2 size);

// Ends the renaming that goes on.
void accept_name(const PanelContext& context, SidePanelState& state);

// A rectangle of a sphere's colour, as large as a text line is high, where the next item is.
void draw_swatch(const PanelContext& context, const Color& color);

}  // namespace sphereview

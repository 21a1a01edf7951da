// What a right click on a row of the list offers, for the selected spheres.
#pragma once

#include "panels/side_panel.hpp"

namespace sphereview {

// Both inside the same ImGui window.
void open_row_menu();
void draw_row_menu(const PanelContext& context, SidePanelState& state);

}  // namespace sphereview

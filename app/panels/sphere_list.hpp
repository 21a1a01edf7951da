// The list of spheres.
#pragma once

#include "panels/side_panel.hpp"

namespace sphereview {

// As wide as the window and so high, and scrolls in itself. Does work for the visible rows alone, and for what changed when there
// is a filter.
void draw_sphere_list(const PanelContext& context, SidePanelState& state, float height);

}  // namespace sphereview

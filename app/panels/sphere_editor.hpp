// The values of the selected sphere, to be changed.
#pragma once

#include "panels/side_panel.hpp"

namespace sphereview {

// Of the primary sphere of the selection; its colour and whether it is hidden are set for all that are selected.
void draw_sphere_editor(const PanelContext& context, SidePanelState& state);

}  // namespace sphereview

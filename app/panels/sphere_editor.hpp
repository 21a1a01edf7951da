// The values of the selected spheres, to be changed.
#pragma once

#include "panels/side_panel.hpp"

namespace sphereview {

// Of all that are selected: where they differ, the ranges are shown, and the sliders and the colour stand at the primary one's. A
// drag moves all by the same difference or scales all by the same factor, what is typed is set for all, each as one step.
void draw_sphere_editor(const PanelContext& context, SidePanelState& state);

// What the selected spheres have in common; nothing while the selection is not of the scene. Kept until either changes.
const SharedValues& shared_of_selection(const PanelContext& context, SidePanelState& state);

}  // namespace sphereview

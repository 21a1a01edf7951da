// What a scene holds beside its spheres: background and camera.
#pragma once

#include "panels/panel_context.hpp"

namespace sphereview {

void draw_scene_panel(const PanelContext& context);

}  // namespace sphereview

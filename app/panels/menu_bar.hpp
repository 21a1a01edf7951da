// The main menu.
#pragma once

#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// Draws ImGui's main menu bar; returns its height. `recent`: paths, the latest first.
float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent);

// The list of all shortcuts and of what the mouse does, as a window that `open` shows.
void draw_help(const PanelContext& context, bool& open);

}  // namespace sphereview

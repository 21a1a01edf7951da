// The main menu.
#pragma once

#include <string>
#include <vector>

#include "panels/help.hpp"
#include "panels/panel_context.hpp"

namespace sphereview {

// Draws ImGui's main menu bar; returns its height. `recent`: paths, the latest first. Widgets: "menu File", "item Save as...",
// "menu Open recent", "recent 0".
float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent);

}  // namespace sphereview

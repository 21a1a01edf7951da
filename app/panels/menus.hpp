// The menu bar, and the list of all shortcuts and of what the mouse does.
#pragma once

#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// As a window that `open` shows; its close button makes `open` false.
void draw_help(const PanelContext& context, bool& open);

// Which menu is open, for the keyboard.
struct MenuKeys {
    std::string open;         // "File"; "" for none
    bool in_submenu = false;  // then Left and Right are the submenu's
    bool begins = false;      // Alt: the first menu is to be opened
    int step = 0;             // to the next menu (1) or the one before (-1)
};

// Draws ImGui's main menu bar; returns its height. Does what `keys` asks for, and notes there what is open. `recent`: paths, the
// latest first. Widgets: "menu File", "item Save as...", "menu Open recent", "recent 0".
float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent, MenuKeys& keys);

}  // namespace sphereview

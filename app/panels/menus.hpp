// The menu bar, the help window with all shortcuts and what the mouse does, and Help > About: the version, what renders, and the
// licences of the parts.
#pragma once

#include <string>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// Draws the help window while `open`; its close button makes `open` false.
void draw_help(const PanelContext& context, bool& open);

// The open menu, for the keyboard.
struct MenuKeys {
    std::string open;         // "File"; "" for none
    bool in_submenu = false;  // then Left and Right are the submenu's
    bool begins = false;      // Alt: the first menu is to be opened
    int step = 0;             // to the next menu (1) or the one before (-1)
};

// Draws ImGui's main menu bar and returns its height. Follows `keys`, and notes the open menu there. `recent`: paths, the latest
// first. Widgets: "menu File", "item Save as...", "menu Open recent", "recent 0".
float draw_menu_bar(const PanelContext& context, const std::vector<std::string>& recent, MenuKeys& keys);

struct About {
    bool shown = false;
    std::vector<std::string> lines{};  // of the licences, once they are shown
};

// Draws a window with a close button. `licenses`, which may be null, is called once, when its long text is first shown. `renderer`:
// as the status bar names it. Widgets: "about", "about copy".
void draw_about(const PanelContext& context, About& about, const std::string& name_and_version, std::string (*licenses)(),
                const std::string& renderer);

}  // namespace sphereview

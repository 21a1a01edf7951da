// The list of all shortcuts and of what the mouse does.
#pragma once

#include <span>
#include <string_view>

#include "panels/panel_context.hpp"

namespace sphereview {

// The README's table is made from this too.
struct MouseHelp {
    std::string_view mouse;  // "Left-drag on a selected sphere"
    std::string_view help;   // "Moves it parallel to the screen; with Shift in depth."
};
std::span<const MouseHelp> mouse_help();

// As a window that `open` shows; its close button makes `open` false.
void draw_help(const PanelContext& context, bool& open);

}  // namespace sphereview

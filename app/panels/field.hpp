// How fields stand below each other.
#pragma once

#include <initializer_list>
#include <vector>

#include "panels/panel_context.hpp"

namespace sphereview {

// Writes the label at the left; the next item takes the rest of the line.
void begin_field(const PanelContext& context, const char* label);

// A button so wide that runs the command, with its help and its shortcut as a tooltip. `label` may be another than the menu's.
void draw_command_button(const PanelContext& context, CommandId id, const char* label, const std::string& widget, float width);

// The widths of buttons side by side that fill the line: each as much wider than its label as the others.
std::vector<float> button_widths(std::initializer_list<const char*> labels);

}  // namespace sphereview

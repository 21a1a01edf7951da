// A colour's three bytes, with a picker.
#pragma once

#include <optional>

#include "panels/panel_context.hpp"

namespace sphereview {

// The gesture that the change of `color` belongs to; nothing while it does not change. Begins a gesture with each drag. The
// widget is ImGui's last item afterwards.
std::optional<std::uint64_t> draw_color_edit(const PanelContext& context, const char* label, Color& color, bool numbers = true);

}  // namespace sphereview

// Colours by numbers: how many spheres have which, the map, and the range, as two handles and typed.
#pragma once

#include <cstdint>
#include <optional>

#include "panels/look_panel.hpp"

namespace sphereview {

// Draws into the current ImGui window. Where the person has chosen another map or range, which `state.colors` has then: the gesture
// in which the spheres are to get these colours. Widgets: "map", "map NAME", "histogram", "handle from", "handle to", "slider
// from", "slider to", "logarithm", "range of data", "range of seen".
std::optional<std::uint64_t> draw_look_range(const PanelContext& context, LookPanelState& state, NumberFields& numbers,
                                             const Property& values);

}  // namespace sphereview

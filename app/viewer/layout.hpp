// The places of the panels and of the picture in the window.
#pragma once

#include <imgui.h>

#include <optional>

#include "viewer/viewer_state.hpp"

namespace sphereview {

// Facts about the picture for the panels; one redraw old.
struct RedrawFacts {
    Status status;
    Inspection inspection;
    DialogKeys keys;
    std::optional<ImTextureID> difference{};   // the chosen picture of the comparison
    std::optional<ImTextureID> seen_by_eye{};  // the picture of the eye whose rays are shown
};

// The width of the side panel nearest to `wanted`, within its setting's range, that leaves the picture enough of `room`.
double panel_width_within(double wanted, double room);

// Draws all panels and returns the place that is left for the picture.
Rectangle draw_panels(ViewerState& state, const PanelContext& context, const RedrawFacts& facts);

}  // namespace sphereview

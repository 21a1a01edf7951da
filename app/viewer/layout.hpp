// Where the panels and the picture are in the window.
#pragma once

#include <imgui.h>

#include <optional>

#include "viewer/viewer_state.hpp"

namespace sphereview {

// What the picture was like when the panels are drawn; one redraw old.
struct RedrawFacts {
    Status status;
    Inspection inspection;
    DialogKeys keys;
    std::optional<ImTextureID> difference{};   // the comparison's picture that is chosen
    std::optional<ImTextureID> seen_by_eye{};  // what the eye sees whose rays are shown
};

// The width of the side panel, in its setting's range, that is nearest to `wanted` and leaves the picture its place where `room`
// is.
double panel_width_within(double wanted, double room);

// Draws all panels and returns where that leaves the picture.
Rectangle draw_panels(ViewerState& state, const PanelContext& context, const RedrawFacts& facts);

}  // namespace sphereview

// Where the panels and the picture are in the window.
#pragma once

#include <imgui.h>

#include <optional>

#include "viewer/viewer_state.hpp"

namespace sphereview {

// What the picture was like when the panels are drawn; one frame old.
struct RedrawFacts {
    Status status;
    Inspection inspection;
    DialogKeys keys;
    std::optional<ImTextureID> difference{};   // the picture of the comparison's
    std::optional<ImTextureID> seen_by_eye{};  // what the eye sees whose rays are shown
};

// The width of the side panel, in its setting's range, that is nearest to `wanted` and leaves the picture its place where `room`
// is.
double panel_width_within(double wanted, double room);

// Draws all panels and returns where that leaves the picture.
Rectangle draw_panels(ViewerState& state, const PanelContext& context, const RedrawFacts& facts);

// Draws a light rectangle beside a dark one over the picture, which are seen on every colour, and a light veil inside; each of an
// opacity up to 255.
void draw_frame(const Rectangle& picture, ImVec2 low, ImVec2 high, int dark, int light, int inside = 0);

// Draws a small cross over the picture, light with a dark edge.
void draw_cross(const Rectangle& picture, ImVec2 middle, float scale);

// Marks a pixel with a cross that leaves it free, and a name beside it.
void draw_pin(const Rectangle& picture, ImVec2 place, float scale, const char* name);

// Marks, over the picture, what an export shows of it, where that is not all. Not over rays in space.
void draw_export_area(const ViewerState& state, const Rectangle& picture);

}  // namespace sphereview

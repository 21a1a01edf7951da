// Draws an eye, its screen and its rays over a picture that sees them from beside.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>

#include "panels/inspector.hpp"
#include "panels/panel_context.hpp"
#include "viewer/hidden_parts.hpp"

namespace sphereview {

struct ViewerState;

// What the rays are drawn over: the window's picture and where it is.
struct DrawnOver {
    const SeenTexels& seen;  // of the window's picture as it is now
    Rectangle area;
    double pixels = 1.0;  // of a screen coordinate
    float scale = 1.0F;
};

// The middle of what the rays go through, while they are shown.
std::optional<glm::dvec3> middle_of_rays(const ViewerState& state);

// `seen_by_eye`: the picture on the screen. `inspection`: of the pixels whose rays are drawn singly. What lies behind a sphere is
// drawn faintly: where a ray goes on is what the drawing is for.
void draw_rays(const ViewerState& state, const Inspection& inspection, const std::optional<ImTextureID>& seen_by_eye,
               const DrawnOver& over);

}  // namespace sphereview

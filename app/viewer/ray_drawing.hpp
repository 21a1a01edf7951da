// Draws an eye, its screen and its rays over a picture that sees them from beside.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>

#include "panels/inspector.hpp"
#include "viewer/ray_canvas.hpp"

namespace sphereview {

struct ViewerState;

// The middle of what the rays go through, while they are shown.
std::optional<glm::dvec3> middle_of_rays(const ViewerState& state);

// `seen_by_eye`: the picture on the screen. `inspection`: of the pixels whose rays are drawn singly. What lies behind a sphere is
// drawn faintly: where a ray goes on is what the drawing is for.
void draw_rays(const ViewerState& state, const Inspection& inspection, const std::optional<ImTextureID>& seen_by_eye,
               const DrawnOver& over);

}  // namespace sphereview

// Draws an eye, its screen and its rays over a picture that sees them from beside.
#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>
#include <optional>

#include "panels/inspector.hpp"
#include "viewer/ray_canvas.hpp"

namespace sphereview {

struct ViewerState;

// The middle of all that the shown rays go through; nothing while none are shown.
std::optional<glm::dvec3> middle_of_rays(const ViewerState& state);

// `seen_by_eye`: the picture on the eye's screen. `inspection`: of the pixels whose rays are drawn singly. Parts behind a sphere
// are drawn faintly, because the drawing is to show where rays go on.
void draw_rays(const ViewerState& state, const Inspection& inspection, const std::optional<ImTextureID>& seen_by_eye,
               const DrawnOver& over);

}  // namespace sphereview

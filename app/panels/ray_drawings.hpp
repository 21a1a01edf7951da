// The inspector's drawings: the plane through the ray, and the ray's quadratics as curves.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>

#include "panels/panel_context.hpp"
#include "panels/ray_section.hpp"

namespace sphereview {

// The colours of a discriminant above 0, at 0 and below.
ImVec4 color_of_sign(int sign);

// Each is as wide as the window. The mouse over a sphere shows its numbers. Returns the sphere that was clicked. `name`: the
// widget's.
std::optional<std::int32_t> draw_ray_section(const PanelContext& context, const char* name, const SectionSubject& of,
                                             std::optional<std::int32_t> subject);
std::optional<std::int32_t> draw_quadratic_plot(const PanelContext& context, const char* name, const PixelExplanation& explanation,
                                                std::int32_t subject);

// Shows the numbers of a drawing's sphere. `behind`: the words for a sphere there, "behind the eye".
void show_numbers(const Scene& scene, const PixelExplanation& explanation, std::int32_t number, const std::string& behind);

}  // namespace sphereview

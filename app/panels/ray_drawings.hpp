// What the inspector draws: the plane through the ray, and the quadratics of the ray as curves.
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

// Each is as wide as the window has room for. The mouse over a sphere says its numbers; returns the sphere that was clicked. `name`
// is as what it is noted.
std::optional<std::int32_t> draw_ray_section(const PanelContext& context, const char* name, const SectionSubject& of,
                                             std::optional<std::int32_t> subject);
std::optional<std::int32_t> draw_quadratic_plot(const PanelContext& context, const char* name, const PixelExplanation& explanation,
                                                std::int32_t subject);

// What the mouse over a sphere of a drawing says; `behind`: of one that lies there, "behind the eye".
void show_numbers(const Scene& scene, const PixelExplanation& explanation, std::int32_t number, const std::string& behind);

}  // namespace sphereview

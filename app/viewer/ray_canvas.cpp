#include "viewer/ray_canvas.hpp"

#include "camera/navigation.hpp"
#include "panels/math_text.hpp"
#include "viewer/view_marks.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

Inks inks_on(const Background& background) {
    const Color& color = background.color;
    const bool light = background.transparent || 3 * color.r + 6 * color.g + color.b > 10 * 140;
    if (!light) return {};
    return {{30, 36, 50, 0.9}, {30, 36, 50, 0.35}, {30, 36, 50, 0.5}, {90, 98, 115, 0.4}, true};
}

RayCanvas::RayCanvas(const ViewerState& state, const DrawnOver& over)
    : state_(state),
      over_(over),
      hidden_(state.scene(), state.camera, state.picture_size, over.seen),
      draw_(*ImGui::GetBackgroundDrawList()) {}

ImVec2 RayCanvas::on_window(const glm::dvec2& place) const { return on_screen(over_.area, over_.pixels, place); }

std::optional<ProjectedLine> RayCanvas::projected(const glm::dvec3& from, const glm::dvec3& to) const {
    return projected_line(state_.camera, state_.picture_size, from, to);
}

std::optional<glm::dvec2> RayCanvas::place(const glm::dvec3& point) const {
    return place_of(state_.camera, state_.picture_size, point);
}

bool RayCanvas::is_hidden(const glm::dvec3& point) const {
    const auto at = place(point);
    return at && hidden_.hides(*at, depth_of(state_.camera, point));
}

void RayCanvas::line(const glm::dvec3& from, const glm::dvec3& to, const Ink& ink, float width, double step) const {
    const auto shown = projected(from, to);
    if (!shown) return;
    hidden_.for_each_run(*shown, step * over_.pixels * static_cast<double>(over_.scale),
                         [&](double begin, double end, bool hidden) {
                             draw_.AddLine(on_window(shown->place_at(begin)), on_window(shown->place_at(end)),
                                           ink.times(hidden ? behind_sphere : 1.0), width * over_.scale);
                         });
}

void RayCanvas::dot_at(const glm::dvec3& point, const Ink& ink, float radius) const {
    const auto at = place(point);
    if (!at) return;
    draw_.AddCircleFilled(on_window(*at), radius * over_.scale, ink.times(is_hidden(point) ? 2.0 * behind_sphere : 1.4), 12);
}

void RayCanvas::ring_at(const glm::dvec3& point, const Ink& ink, float radius) const {
    const auto at = place(point);
    if (!at) return;
    const ImVec2 middle = on_window(*at);
    const double opacity = is_hidden(point) ? 2.0 * behind_sphere : 1.0;
    draw_.AddCircle(middle, radius * over_.scale, dark_ink.times(opacity), 24, 4.0F * over_.scale);
    draw_.AddCircle(middle, radius * over_.scale, ink.times(opacity), 24, 2.0F * over_.scale);
}

void RayCanvas::words(ImVec2 middle, const std::string& text, const Ink& ink) const {
    const std::string shown = in_glyphs(text);
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    const float pad = 3.0F * over_.scale;
    const ImVec2 low{std::round(middle.x - 0.5F * size.x), std::round(middle.y - 0.5F * size.y)};
    draw_.AddRectFilled({low.x - pad, low.y - 1.0F}, {low.x + size.x + pad, low.y + size.y + 1.0F}, dark_ink.times(0.85), pad);
    draw_.AddText(low, ink.times(1.0), shown.c_str());
}

}  // namespace sphereview

#include "panels/timeline_icons.hpp"

#include <cmath>
#include <numbers>

namespace sphereview {

namespace {

void draw_arrow_head(const IconPlace& icon, ImVec2 tip, ImVec2 along) {
    constexpr float length = 0.4F;
    const ImVec2 back{tip.x - length * along.x, tip.y - length * along.y};
    const ImVec2 side{-length * 0.75F * along.y, length * 0.75F * along.x};
    ImGui::GetWindowDrawList()->AddTriangleFilled(icon.at(tip.x, tip.y), icon.at(back.x + side.x, back.y + side.y),
                                                  icon.at(back.x - side.x, back.y - side.y), icon.color);
}

}  // namespace

void draw_triangle(const IconPlace& icon, float tip, float back) {
    ImGui::GetWindowDrawList()->AddTriangleFilled(icon.at(tip, 0.0F), icon.at(back, 0.5F), icon.at(back, -0.5F), icon.color);
}

void draw_bar(const IconPlace& icon, float left, float right) {
    ImGui::GetWindowDrawList()->AddRectFilled(icon.at(left, -0.5F), icon.at(right, 0.5F), icon.color);
}

void draw_repeat(const IconPlace& icon, Repeat repeat) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float line = 0.13F * icon.size;
    if (repeat == Repeat::loop) {
        constexpr float end = 1.6F * std::numbers::pi_v<float>;
        constexpr float radius = 0.42F;
        draw.PathArcTo(icon.middle, radius * icon.size, 0.0F, end, 24);
        draw.PathStroke(icon.color, 0, line);
        const float x = std::cos(end);
        const float y = std::sin(end);
        draw_arrow_head(icon, {radius * x - 0.16F * y, radius * y + 0.16F * x}, {-y, x});
        return;
    }
    draw.AddLine(icon.at(-0.5F, 0.0F), icon.at(0.4F, 0.0F), icon.color, line);
    draw_arrow_head(icon, {0.55F, 0.0F}, {1.0F, 0.0F});
    if (repeat == Repeat::back_and_forth) {
        draw_arrow_head(icon, {-0.55F, 0.0F}, {-1.0F, 0.0F});
    } else {
        draw_bar(icon, 0.58F, 0.72F);
    }
}

}  // namespace sphereview

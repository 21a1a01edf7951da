#include "panels/list_scroll.hpp"

#include <imgui.h>

#include <algorithm>

namespace sphereview {

void ListScroll::set_size(std::size_t rows, double seen) {
    if (static_cast<double>(rows) != rows_) shown_.reset();
    rows_ = static_cast<double>(rows);
    seen_ = std::max(seen, 1.0);
    above_ = std::min(above_, most());
    if (shown_) show(*shown_);
}

double ListScroll::most() const { return std::max(rows_ - seen_, 0.0); }

void ListScroll::to(double above) {
    above_ = std::clamp(above, 0.0, most());
    shown_.reset();
}

void ListScroll::show(std::size_t row) {
    const auto at = static_cast<double>(row);
    if (at < above_ || at + 1.0 > above_ + seen_) to(at - 0.5 * (seen_ - 1.0));
    shown_ = row;
}

void ListScroll::draw_bar(const PanelContext& context, float left, float top, float width, float height) {
    const float shortest = std::min(2.0F * width, height);
    const float thumb = std::max(shortest, height * static_cast<float>(seen_ / std::max(rows_, seen_)));
    const float track = std::max(height - thumb, 1.0F);
    const auto thumb_top = [&] { return most() > 0.0 ? top + track * static_cast<float>(above_ / most()) : top; };
    ImGui::SetCursorScreenPos({left, top});
    ImGui::InvisibleButton("##scroll bar", {width, height});
    note_widget(context, "list scroll bar");
    const float mouse = ImGui::GetMousePos().y;
    if (ImGui::IsItemActivated()) {
        const float in_thumb = mouse - thumb_top();
        grabbed_ = in_thumb >= 0.0F && in_thumb <= thumb ? in_thumb : 0.5F * thumb;
    }
    const bool held = ImGui::IsItemActive();
    if (held) to(most() * std::clamp(static_cast<double>((mouse - grabbed_ - top) / track), 0.0, 1.0));
    const ImGuiCol color = held                     ? ImGuiCol_ScrollbarGrabActive
                           : ImGui::IsItemHovered() ? ImGuiCol_ScrollbarGrabHovered
                                                    : ImGuiCol_ScrollbarGrab;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().ScrollbarRounding;
    list.AddRectFilled({left, top}, {left + width, top + height}, ImGui::GetColorU32(ImGuiCol_ScrollbarBg), rounding);
    list.AddRectFilled({left, thumb_top()}, {left + width, thumb_top() + thumb}, ImGui::GetColorU32(color), rounding);
}

}  // namespace sphereview

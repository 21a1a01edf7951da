#include "panels/color_edit.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sphereview {

std::optional<std::uint64_t> draw_color_edit(const PanelContext& context, const char* label, Color& color, bool numbers) {
    std::array<float, 3> parts = {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
    for (float& part : parts) part /= static_cast<float>(color_max);
    const ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_Uint8 | ImGuiColorEditFlags_NoDragDrop | (numbers ? 0 : ImGuiColorEditFlags_NoInputs);
    const bool changed = ImGui::ColorEdit3(label, parts.data(), flags);
    // Its parts, and its picker, count as the item: a drag in one of them activates it.
    if (ImGui::IsItemActivated()) ++context.gesture;
    if (!changed) return std::nullopt;
    const auto byte = [](float part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0F, 1.0F) * static_cast<float>(color_max)));
    };
    const Color edited{byte(parts[0]), byte(parts[1]), byte(parts[2])};
    if (edited == color) return std::nullopt;
    color = edited;
    // What comes from no drag, such as a pasted colour, is a step of its own.
    return ImGui::IsItemActive() || ImGui::IsItemDeactivated() ? context.gesture : 0;
}

}  // namespace sphereview

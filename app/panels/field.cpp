#include "panels/field.hpp"

#include <imgui.h>

#include <algorithm>

namespace sphereview {

void begin_field(const PanelContext& context, const char* label) {
    const float column = ImGui::CalcTextSize("background").x + 10.0F * context.scale;  // the longest
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(left + column);
    ImGui::SetNextItemWidth(std::max(1.0F, ImGui::GetContentRegionAvail().x));
}

void draw_command_button(const PanelContext& context, CommandId id, const char* label, const std::string& widget, float width) {
    ImGui::BeginDisabled(!context.enabled(id));
    const bool pressed = ImGui::Button(label, {width, 0.0F});
    ImGui::EndDisabled();
    note_widget(context, widget);
    if (pressed) context.actions.emplace_back(RunCommand{id});
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const CommandInfo& info = info_of(id);
    const std::string shortcut = info.shortcut.empty() ? "" : "\n" + every_shortcut(info.shortcut);
    ImGui::SetTooltip("%s%s", std::string(info.help).c_str(), shortcut.c_str());
}

std::vector<float> button_widths(std::initializer_list<const char*> labels) {
    const auto count = static_cast<float>(labels.size());
    float left = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x * (count - 1.0F);
    std::vector<float> widths;
    for (const char* label : labels) {
        widths.push_back(ImGui::CalcTextSize(label, nullptr, true).x);
        left -= widths.back();
    }
    for (float& width : widths) width = std::max(1.0F, width + left / count);
    return widths;
}

}  // namespace sphereview

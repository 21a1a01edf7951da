#include "panels/dialog_parts.hpp"

#include <imgui.h>

#include <algorithm>

namespace sphereview {

namespace {

float text_height(const std::string& text, float width) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, width).y;
}

float highest_fault() { return 5.0F * ImGui::GetTextLineHeight(); }

}  // namespace

void draw_text(const std::string& text, float width, float most) {
    const bool scrolled = text_height(text, width) > most;
    const float wrap_at = scrolled ? width - ImGui::GetStyle().ScrollbarSize : ImGui::GetCursorPosX() + width;
    if (scrolled) ImGui::BeginChild("text", {width, most});
    ImGui::PushTextWrapPos(wrap_at);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    if (scrolled) ImGui::EndChild();
}

void draw_fault(const std::string& text, float width) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0F, 0.48F, 0.44F, 1.0F));
    draw_text(text, width, highest_fault());
    ImGui::PopStyleColor();
}

float fault_height(const std::string& text, float width) { return std::min(text_height(text, width), highest_fault()); }

FormEnd draw_form_end(const PanelContext& context, const std::string& name, const char* ok, bool possible, const DialogKeys& keys) {
    FormEnd end = FormEnd::open;
    const ImVec2 size(96.0F * context.scale, 0.0F);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button(ok, size)) end = FormEnd::ok;
    ImGui::EndDisabled();
    ImGui::PopStyleColor();
    note_widget(context, name + " ok");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size)) end = FormEnd::cancel;
    note_widget(context, name + " cancel");
    if (end != FormEnd::open) return end;
    if (keys.escape) return FormEnd::cancel;
    return keys.enter && possible ? FormEnd::ok : FormEnd::open;
}

}  // namespace sphereview

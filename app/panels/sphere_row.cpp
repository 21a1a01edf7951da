#include "panels/sphere_row.hpp"

#include <algorithm>
#include <cmath>

#include "panels/number_text.hpp"
#include "panels/text_input.hpp"

namespace sphereview {

namespace {

ImU32 color_of(const Color& color, float opacity = 1.0F) {
    return IM_COL32(color.r, color.g, color.b, static_cast<int>(std::lround(255.0F * opacity)));
}

// Two lids and a pupil, or one closed lid.
void draw_eye(ImVec2 middle, float size, bool open, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = 0.32F * size;
    const float line = std::max(1.0F, 0.06F * size);
    const ImVec2 left{middle.x - half, middle.y};
    const ImVec2 right{middle.x + half, middle.y};
    const auto lid = [&](float height) {
        const ImVec2 bend{middle.x, middle.y + height};
        list.AddBezierQuadratic(left, bend, right, color, line);
    };
    lid(0.36F * size);
    if (!open) return;
    lid(-0.36F * size);
    list.AddCircleFilled(middle, 0.1F * size, color);
}

void swatch(const Color& color, ImVec2 low, ImVec2 high, float scale, float opacity) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, color_of(color, opacity), 2.0F * scale);
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border), 2.0F * scale);
}

void draw_name_field(const PanelContext& context, SidePanelState& state, ImVec2 place, float width) {
    ImGui::SetCursorScreenPos(place);
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {2.0F * context.scale, ImGui::GetStyle().FramePadding.y});
    if (state.focus_rename) ImGui::SetKeyboardFocusHere();
    input_text("##rename", "name", state.new_name, ImGuiInputTextFlags_AutoSelectAll);
    note_widget(context, "rename");
    ImGui::PopStyleVar();
    if (ImGui::IsItemActive()) state.focus_rename = false;
    if (ImGui::IsItemDeactivated()) accept_name(context, state);  // Escape gave the old name back
}

// Hidden spheres are dimmed. A title that does not fit is cut off, and told in full by a tooltip.
void draw_words(const PanelContext& context, std::uint32_t number, ImVec2 place, float right, bool hovered) {
    const Scene& scene = context.document.scene();
    const Sphere& sphere = scene.spheres[number];
    const auto name = scene.names.find(number);
    const std::string title = name == scene.names.end() ? "sphere " + std::to_string(number) : name->second;
    const std::string radius = short_text(sphere.radius);
    const float radius_left = right - ImGui::CalcTextSize(radius.c_str()).x;
    const float title_right = radius_left - ImGui::GetStyle().ItemSpacing.x;
    const ImVec4 dim = ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    ImGui::PushStyleColor(ImGuiCol_Text, sphere.hidden ? dim : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    ImGui::SetCursorScreenPos(place);
    ImGui::PushClipRect(place, {std::max(place.x, title_right), place.y + ImGui::GetTextLineHeight()}, true);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopClipRect();
    ImGui::PopStyleColor();
    ImGui::SetCursorScreenPos({radius_left, place.y});
    ImGui::PushStyleColor(ImGuiCol_Text, dim);
    ImGui::TextUnformatted(radius.c_str());
    ImGui::PopStyleColor();
    if (hovered && place.x + ImGui::CalcTextSize(title.c_str()).x > title_right) ImGui::SetTooltip("%s", title.c_str());
}

}  // namespace

void accept_name(const PanelContext& context, SidePanelState& state) {
    const std::uint32_t number = *state.renaming;
    const Scene& scene = context.document.scene();
    const auto old = scene.names.find(number);
    if (state.new_name != (old == scene.names.end() ? "" : old->second)) {
        context.actions.emplace_back(EditScene{RenameSphere{number, state.new_name}, "Rename " + title_of(scene, number)});
    }
    state.renaming.reset();
}

void draw_swatch(const PanelContext& context, const Color& color) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({side, side});
    swatch(color, low, {low.x + side, low.y + side}, context.scale, 1.0F);
}

RowResult draw_sphere_row(const PanelContext& context, SidePanelState& state, std::uint32_t number, ImVec2 place, ImVec2 size) {
    const Sphere& sphere = context.document.scene().spheres[number];
    const std::string row = context.rectangles != nullptr ? "row " + std::to_string(number) : "";
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float line = ImGui::GetTextLineHeight();
    const float text_top = place.y + 0.5F * (size.y - line);
    RowResult result;
    ImGui::PushID(static_cast<int>(number));

    ImGui::SetCursorScreenPos(place);
    result.eye = ImGui::InvisibleButton("eye", {size.y, size.y});
    note_widget(context, row + " eye");
    const bool eye_hovered = ImGui::IsItemHovered();
    if (eye_hovered) ImGui::SetTooltip("%s", sphere.hidden ? "Show" : "Hide");

    const bool renaming = state.renaming == number;
    bool hovered = eye_hovered;
    ImGui::SetCursorScreenPos({place.x + size.y, place.y});
    const ImVec2 rest{std::max(1.0F, size.x - size.y), size.y};
    if (renaming) {
        ImGui::Dummy(rest);
    } else {
        ImGui::InvisibleButton("row", rest);
        hovered = hovered || ImGui::IsItemHovered();
        result.pressed = ImGui::IsItemActivated();
        result.double_clicked = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        result.menu = ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
        result.dragging = ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    }
    note_widget(context, row);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{place.x + size.x, place.y + size.y};
    if (context.selection.contains(number)) list.AddRectFilled(place, end, ImGui::GetColorU32(ImGuiCol_Header));
    if (hovered || context.hovered == number) list.AddRectFilled(place, end, ImGui::GetColorU32(ImGuiCol_HeaderHovered, 0.6F));
    if (hovered) context.hovered = number;
    draw_eye({place.x + 0.5F * size.y, place.y + 0.5F * size.y}, size.y, !sphere.hidden,
             ImGui::GetColorU32(sphere.hidden || !eye_hovered ? ImGuiCol_TextDisabled : ImGuiCol_Text));
    const ImVec2 corner{place.x + size.y + padding, text_top};
    swatch(sphere.color, corner, {corner.x + line, corner.y + line}, context.scale, sphere.hidden ? 0.4F : 1.0F);
    const float title_left = corner.x + line + 2.0F * padding;
    if (renaming) {
        draw_name_field(context, state, {title_left, place.y + 0.5F * (size.y - ImGui::GetFrameHeight())},
                        std::max(1.0F, end.x - title_left));
    } else {
        draw_words(context, number, {title_left, text_top}, end.x - padding, hovered);
    }
    ImGui::PopID();
    return result;
}

}  // namespace sphereview

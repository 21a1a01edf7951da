#include "panels/style.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace sphereview {

namespace {

ImVec4 grey(float brightness, float opacity = 1.0F) {
    // A trace of blue, so that the greys of the panels differ from those of a picture.
    return {brightness * 0.97F, brightness, brightness * 1.05F, opacity};
}

ImVec4 accent(float opacity) { return {0.29F, 0.56F, 0.89F, opacity}; }

void set_colors(ImGuiStyle& style) {
    const auto set = [&style](ImGuiCol what, const ImVec4& color) { style.Colors[what] = color; };
    set(ImGuiCol_Text, grey(0.90F));
    set(ImGuiCol_TextDisabled, grey(0.58F));
    set(ImGuiCol_WindowBg, grey(0.125F));
    set(ImGuiCol_ChildBg, grey(0.10F, 0.0F));
    set(ImGuiCol_PopupBg, grey(0.15F));
    set(ImGuiCol_MenuBarBg, grey(0.16F));
    set(ImGuiCol_Border, grey(0.30F));
    set(ImGuiCol_Separator, grey(0.26F));
    set(ImGuiCol_TitleBg, grey(0.11F));
    set(ImGuiCol_TitleBgActive, grey(0.18F));
    set(ImGuiCol_FrameBg, grey(0.20F));
    set(ImGuiCol_FrameBgHovered, grey(0.25F));
    set(ImGuiCol_FrameBgActive, grey(0.28F));
    set(ImGuiCol_Button, grey(0.25F));
    set(ImGuiCol_ButtonHovered, grey(0.31F));
    set(ImGuiCol_ButtonActive, grey(0.37F));
    set(ImGuiCol_Header, accent(0.38F));
    set(ImGuiCol_HeaderHovered, accent(0.26F));
    set(ImGuiCol_HeaderActive, accent(0.50F));
    set(ImGuiCol_CheckMark, {0.45F, 0.68F, 0.96F, 1.0F});
    set(ImGuiCol_SliderGrab, accent(0.85F));
    set(ImGuiCol_SliderGrabActive, accent(1.0F));
    set(ImGuiCol_ScrollbarBg, grey(0.10F, 0.5F));
    set(ImGuiCol_ScrollbarGrab, grey(0.32F));
    set(ImGuiCol_ScrollbarGrabHovered, grey(0.40F));
    set(ImGuiCol_ScrollbarGrabActive, grey(0.46F));
    set(ImGuiCol_TableRowBgAlt, {1.0F, 1.0F, 1.0F, 0.03F});
    set(ImGuiCol_TableBorderLight, grey(0.22F));
    set(ImGuiCol_TableHeaderBg, grey(0.17F));
    set(ImGuiCol_TextSelectedBg, accent(0.45F));
    set(ImGuiCol_ModalWindowDimBg, {0.0F, 0.0F, 0.0F, 0.50F});
}

}  // namespace

void apply_style(float scale) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    set_colors(style);
    style.WindowPadding = ImVec2(10.0F, 10.0F);
    style.FramePadding = ImVec2(8.0F, 4.0F);
    style.ItemSpacing = ImVec2(8.0F, 6.0F);
    style.ItemInnerSpacing = ImVec2(6.0F, 4.0F);
    style.CellPadding = ImVec2(6.0F, 3.0F);
    style.ScrollbarSize = 13.0F;
    style.GrabMinSize = 10.0F;
    style.WindowRounding = 6.0F;
    style.PopupRounding = 6.0F;
    style.ChildRounding = 4.0F;
    style.FrameRounding = 4.0F;
    style.GrabRounding = 4.0F;
    style.ScrollbarRounding = 6.0F;
    style.WindowTitleAlign = ImVec2(0.5F, 0.5F);
    style.ScaleAllSizes(scale);
    // Lines are whole pixels, or they blur; ScaleAllSizes() leaves them alone.
    const float line = std::max(1.0F, std::floor(scale));
    style.WindowBorderSize = line;
    style.PopupBorderSize = line;
    style.ChildBorderSize = line;
    style.FrameBorderSize = 0.0F;
    ImGui::GetStyle() = style;
}

}  // namespace sphereview

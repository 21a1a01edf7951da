#include "viewer/layout.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/inspector.hpp"
#include "panels/menus.hpp"
#include "panels/status.hpp"

namespace sphereview {

namespace {

constexpr float splitter_width = 6.0F;
constexpr float narrowest_picture = 100.0F;

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

void place_window(const Rectangle& area) {
    ImGui::SetNextWindowPos(ImVec2(area.x, area.y));
    ImGui::SetNextWindowSize(ImVec2(area.width, area.height));
}

// The panel's left edge, which can be dragged. `shown`: the panel's width now, which may be less than the person chose.
void draw_splitter(ViewerState& state, const PanelContext& context, const Rectangle& area, double shown) {
    place_window(area);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::Begin("##splitter", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar);
    ImGui::InvisibleButton("##edge", ImVec2(area.width, std::max(area.height, 1.0F)));
    note_widget(context, "splitter");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    // A frame's movement comes before its release, and before its press: that was not yet the edge's.
    if ((ImGui::IsItemActive() && !ImGui::IsItemActivated()) || ImGui::IsItemDeactivated()) {
        const auto by = static_cast<double>(ImGui::GetIO().MouseDelta.x / context.scale);
        if (by != 0.0) state.settings.panel_width = panel_width_range.nearest(shown - by);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void draw_inspector_window(ViewerState& state, const PanelContext& context, const RedrawFacts& facts, const Rectangle& picture) {
    const float margin = 10.0F * context.scale;
    ImGui::SetNextWindowPos(ImVec2(picture.x + margin, picture.y + margin), ImGuiCond_FirstUseEver);
    const auto side = [&](float wanted, float room) {
        return std::max(std::min(wanted * context.scale, room - 2.0F * margin), 120.0F * context.scale);
    };
    ImGui::SetNextWindowSize(ImVec2(side(480.0F, picture.width), side(560.0F, picture.height)), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowBgAlpha(0.92F);
    ImGui::Begin("Pixel inspector", &state.inspector_shown, ImGuiWindowFlags_NoSavedSettings);
    draw_inspector(context, facts.inspected);
    ImGui::End();
}

}  // namespace

double panel_width_within(double wanted, double room) {
    return std::min(panel_width_range.nearest(wanted), panel_width_range.nearest(room));
}

Rectangle draw_panels(ViewerState& state, const PanelContext& context, const RedrawFacts& facts) {
    // The windows around the picture have no border: ImGui's, if it is wider than a pixel, reaches beyond its window. And no round
    // corners: nothing is behind them.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    const float menu_height =
        std::ceil(draw_menu_bar(context, state.settings.recent, state.menu_keys));  // the picture has whole pixels
    const float status_height = std::round(ImGui::GetFrameHeight() + 2.0F * context.scale);
    Rectangle picture{0.0F, menu_height, whole.x, std::max(whole.y - menu_height - status_height, 0.0F)};

    if (state.panel_shown) {
        const float splitter = splitter_width * context.scale;
        const float room = whole.x - splitter - narrowest_picture * context.scale;
        // A small window or large text narrows the panel for as long as that lasts: what the person chose is kept.
        const double shown = panel_width_within(state.settings.panel_width, room / context.scale);
        const float widest = std::max(room, static_cast<float>(panel_width_range.least));
        const float width = std::floor(std::min(static_cast<float>(shown) * context.scale, widest));
        const Rectangle panel{whole.x - width, picture.y, width, picture.height};
        place_window(panel);
        // The list scrolls in itself, by its own means.
        const ImGuiWindowFlags wheel = state.side_panel.list_hovered ? ImGuiWindowFlags_NoScrollWithMouse : 0;
        ImGui::Begin("##panel", nullptr, fixed_window | wheel);
        draw_side_panel(context, state.side_panel);
        ImGui::End();
        draw_splitter(state, context, {panel.x - splitter, panel.y, splitter, panel.height}, shown);
        picture.width = std::max(panel.x - splitter, 0.0F);
    }

    place_window({0.0F, whole.y - status_height, whole.x, status_height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0F * context.scale, 1.0F * context.scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::Begin("##status", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    draw_status_bar(context, facts.status);
    ImGui::End();
    ImGui::PopStyleVar(4);

    if (draw_messages(context, state.messages, picture)) cancel_work(state);
    if (state.is_at_start()) {
        const bool has_keys = state.dialogs.empty() && !state.help_shown && !state.about.shown && !ImGui::GetIO().WantTextInput &&
                              !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
        draw_start_page(context, state.start_page, state.settings.recent, picture, has_keys);
    }
    draw_measuring(context, state.measuring, picture);
    if (state.inspector_shown) draw_inspector_window(state, context, facts, picture);
    if (state.help_shown) draw_help(context, state.help_shown);
    draw_about(context, state.about, state.options.program.name_and_version, state.options.program.licenses, facts.status.renderer);
    draw_dialogs(context, state.dialogs, facts.keys);
    return picture;
}

void draw_frame(const Rectangle& picture, ImVec2 low, ImVec2 high, int dark, int light, int inside) {
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    draw->PushClipRect(ImVec2(picture.x, picture.y), ImVec2(picture.x + picture.width, picture.y + picture.height));
    draw->AddRectFilled(low, high, IM_COL32(255, 255, 255, inside));
    draw->AddRect(ImVec2(low.x - 1.0F, low.y - 1.0F), ImVec2(high.x + 1.0F, high.y + 1.0F), IM_COL32(0, 0, 0, dark));
    draw->AddRect(low, high, IM_COL32(255, 255, 255, light));
    draw->PopClipRect();
}

void draw_cross(const Rectangle& picture, ImVec2 middle, float scale) {
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    draw->PushClipRect(ImVec2(picture.x, picture.y), ImVec2(picture.x + picture.width, picture.y + picture.height));
    const auto bars = [&](float length, float thickness, ImU32 color) {
        const ImVec2 along(length * scale, 0.5F * thickness * scale);
        draw->AddRectFilled(ImVec2(middle.x - along.x, middle.y - along.y), ImVec2(middle.x + along.x, middle.y + along.y), color);
        draw->AddRectFilled(ImVec2(middle.x - along.y, middle.y - along.x), ImVec2(middle.x + along.y, middle.y + along.x), color);
    };
    bars(9.0F, 4.0F, IM_COL32(0, 0, 0, 170));
    bars(8.0F, 2.0F, IM_COL32(255, 255, 255, 230));
    draw->PopClipRect();
}

void draw_export_area(const ViewerState& state, const Rectangle& picture) {
    if (!state.export_area_shown) return;
    const PictureSize size{state.settings.export_width, state.settings.export_height};
    // Both show `right` and `up` over half their shorter side.
    const float unit = 0.5F * std::min(picture.width, picture.height) / static_cast<float>(size.shorter_side());
    const float half_width = unit * static_cast<float>(size.width);
    const float half_height = unit * static_cast<float>(size.height);
    if (half_width > 0.5F * picture.width - 1.0F && half_height > 0.5F * picture.height - 1.0F) return;
    const ImVec2 middle(picture.x + 0.5F * picture.width, picture.y + 0.5F * picture.height);
    const ImVec2 low(std::floor(middle.x - half_width), std::floor(middle.y - half_height));
    const ImVec2 high(std::ceil(middle.x + half_width), std::ceil(middle.y + half_height));
    draw_frame(picture, low, high, 140, 90);
}

}  // namespace sphereview

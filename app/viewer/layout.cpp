#include "viewer/layout.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/comparison.hpp"
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

// The edge of a panel, which can be dragged. Returns by how much, to the right. Noted as `name`.
float draw_splitter(const PanelContext& context, const char* name, const Rectangle& area) {
    place_window(area);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::Begin((std::string("##") + name).c_str(), nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar);
    ImGui::InvisibleButton("##edge", ImVec2(area.width, std::max(area.height, 1.0F)));
    note_widget(context, name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    // A frame's movement comes before its release, and before its press: that was not yet the edge's.
    const bool dragged = (ImGui::IsItemActive() && !ImGui::IsItemActivated()) || ImGui::IsItemDeactivated();
    ImGui::End();
    ImGui::PopStyleVar(2);
    return dragged ? ImGui::GetIO().MouseDelta.x : 0.0F;
}

// Beside the picture, at its left, so that no pixel is covered by its own explanation. Returns what is left of the picture's place.
Rectangle draw_inspector_beside(ViewerState& state, const PanelContext& context, const RedrawFacts& facts, Rectangle picture) {
    const float splitter = splitter_width * context.scale;
    constexpr float most = 0.55F;  // of the room: the picture is what it is about
    const double wanted = inspector_width_range.nearest(state.settings.inspector_width);
    const float width = std::floor(std::min(static_cast<float>(wanted) * context.scale, most * picture.width));
    place_window({picture.x, picture.y, width, picture.height});
    ImGui::Begin("##inspector", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    draw_inspector(context, facts.inspection, state.inspector);
    ImGui::End();
    const Rectangle edge{picture.x + width, picture.y, splitter, picture.height};
    if (const float by = draw_splitter(context, "inspector splitter", edge); by != 0.0F) {
        state.settings.inspector_width = inspector_width_range.nearest(static_cast<double>((width + by) / context.scale));
    }
    const float taken = std::min(width + splitter, picture.width);
    return {picture.x + taken, picture.y, picture.width - taken, picture.height};
}

// What the eye sees whose rays are shown: the pixel under the pointer there is the eye's.
void draw_rays_over(ViewerState& state, const PanelContext& context, const RedrawFacts& facts, const Rectangle& picture) {
    RaysInSpace& rays = state.rays;
    RaysFacts shown = facts_of_rays(state, facts.inspection.first);
    shown.picture = facts.seen_by_eye;
    const RaysAnswer answer = draw_rays_panel(context, shown, rays.choice, picture);
    const double pixels = picture.width > 0.0F ? state.picture_size.width / static_cast<double>(picture.width) : 1.0;
    fly_beside(state, {pixels * static_cast<double>(answer.size.x), pixels * static_cast<double>(answer.size.y)});
    rays.pointed.reset();
    if (!answer.pointed) return;
    rays.pointed = PinnedPixel{*answer.pointed, rays.size};
    if (answer.clicked) pin(state.pins, *rays.pointed, answer.beside);
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
        const auto by = static_cast<double>(
            draw_splitter(context, "splitter", {panel.x - splitter, panel.y, splitter, panel.height}) / context.scale);
        if (by != 0.0) state.settings.panel_width = panel_width_range.nearest(shown - by);
        picture.width = std::max(panel.x - splitter, 0.0F);
    }
    if (state.inspector_shown) picture = draw_inspector_beside(state, context, facts, picture);

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
    if (state.rays.on) draw_rays_over(state, context, facts, picture);
    if (state.comparison && state.comparison->open) {
        std::optional<ImVec2> pinned;
        if (state.inspector_shown && !state.rays.on && state.pins.first) {
            const glm::dvec2 place = place_in(state.picture_size, *state.pins.first);
            const double pixel = static_cast<double>(picture.width) / state.picture_size.width;
            pinned = ImVec2(picture.x + static_cast<float>(pixel * place.x), picture.y + static_cast<float>(pixel * place.y));
        }
        draw_comparison(context, state.comparison->words, facts.difference ? &*facts.difference : nullptr, picture, pinned,
                        state.comparison->open);
    }
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

void draw_pin(const Rectangle& picture, ImVec2 place, float scale, const char* name) {
    ImDrawList* draw = ImGui::GetBackgroundDrawList();
    draw->PushClipRect(ImVec2(picture.x, picture.y), ImVec2(picture.x + picture.width, picture.y + picture.height));
    const ImVec2 middle(std::floor(place.x) + 0.5F, std::floor(place.y) + 0.5F);
    const auto arms = [&](float from, float to, float thickness, ImU32 color) {
        for (const auto& [x, y] : {std::pair{1.0F, 0.0F}, std::pair{-1.0F, 0.0F}, std::pair{0.0F, 1.0F}, std::pair{0.0F, -1.0F}}) {
            draw->AddLine(ImVec2(middle.x + x * from * scale, middle.y + y * from * scale),
                          ImVec2(middle.x + x * to * scale, middle.y + y * to * scale), color, thickness * scale);
        }
    };
    arms(3.0F, 13.0F, 4.0F, IM_COL32(0, 0, 0, 190));
    arms(4.0F, 12.0F, 2.0F, IM_COL32(255, 220, 90, 255));
    const ImVec2 beside(middle.x + 8.0F * scale, middle.y + 6.0F * scale);
    draw->AddText(ImVec2(beside.x + 1.0F, beside.y + 1.0F), IM_COL32(0, 0, 0, 220), name);
    draw->AddText(beside, IM_COL32(255, 220, 90, 255), name);
    draw->PopClipRect();
}

void draw_export_area(const ViewerState& state, const Rectangle& picture) {
    if (!state.export_area_shown || state.rays.on) return;
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

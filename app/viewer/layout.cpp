#include "viewer/layout.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/comparison.hpp"
#include "panels/inspector.hpp"
#include "panels/menus.hpp"
#include "panels/status.hpp"
#include "panels/timeline.hpp"
#include "panels/widgets.hpp"
#include "viewer/film_export.hpp"
#include "viewer/frame_player.hpp"
#include "viewer/view_marks.hpp"

namespace sphereview {

namespace {

constexpr float splitter_width = 6.0F;
constexpr float narrowest_picture = 100.0F;
// What is smaller yields to the picture: nothing could be read in it.
constexpr float narrowest_panel = 200.0F;
constexpr float narrowest_inspector = 120.0F;
constexpr float timeline_margin = 10.0F;  // at the sides
constexpr float lowest_picture = 100.0F;  // above the status bar
// Where a tool's words lie over the picture, it has to be wide enough for them and for what they are about.
constexpr float narrowest_under_tool = 280.0F;
constexpr float narrowest_under_rays = 400.0F;  // the view from beside has to be seen beside their panel
// Heights of the axes in the picture's corner, with their margin, and of the rays' panel, to be readable.
constexpr float axes_height = 116.0F;
constexpr float lowest_rays = 270.0F;
// With the inspector open, the picture keeps this part of the window, and the inspector so much, as far as the side panel can
// yield.
constexpr float least_picture_share = 0.32F;
constexpr float inspector_at_least = 260.0F;

constexpr ImGuiWindowFlags fixed_window = bare_window | ImGuiWindowFlags_NoBringToFrontOnFocus;

void place_window(const Rectangle& area) {
    ImGui::SetNextWindowPos(ImVec2(area.x, area.y));
    ImGui::SetNextWindowSize(ImVec2(area.width, area.height));
}

// ImGui's windows begin at whole pixels: what lies between two of them ends there, too.
float whole_pixels(float length, const PanelContext& context) { return std::round(length * context.scale); }

// What the side panel leaves for the picture and for the tools that are open, at least. Someone who opened a tool wants to read it,
// so the side panel narrows for that, and gives way where it would be too narrow itself.
float room_beside_panel(const ViewerState& state, const PanelContext& context, float whole, bool compares) {
    const float scale = context.scale;
    const float least = state.rays.on ? narrowest_under_rays : state.measuring.on ? narrowest_under_tool : narrowest_picture;
    float picture = least * scale;
    // Nothing is there yet that the panel could be used for: the page comes first.
    if (state.is_at_start() && !compares) picture = std::max(picture, start_page_room(context));
    if (!state.inspector_shown) return picture;
    return std::max(picture, least_picture_share * whole) + (inspector_at_least + splitter_width) * scale;
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
    // A redraw's movement comes before its release, and before its press: that was not yet the edge's.
    const bool dragged = (ImGui::IsItemActive() && !ImGui::IsItemActivated()) || ImGui::IsItemDeactivated();
    ImGui::End();
    ImGui::PopStyleVar(2);
    return dragged ? ImGui::GetIO().MouseDelta.x : 0.0F;
}

// Beside the picture, at its left, so that no pixel is covered by its own explanation. Returns what is left of the picture's place.
Rectangle draw_inspector_beside(ViewerState& state, const PanelContext& context, const RedrawFacts& facts, Rectangle picture) {
    const float splitter = whole_pixels(splitter_width, context);
    constexpr float most = 0.55F;  // of the room: the picture is what it is about
    const double wanted = inspector_width_range.nearest(state.settings.inspector_width);
    const float width = std::floor(std::min(static_cast<float>(wanted) * context.scale, most * picture.width));
    if (width < narrowest_inspector * context.scale) return picture;
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

// Under the picture. Returns what is left of the picture's place.
Rectangle draw_timeline_below(ViewerState& state, const PanelContext& context, Rectangle picture) {
    const float padding = 6.0F * context.scale;
    const float height = std::ceil(timeline_height() + 2.0F * padding);
    if (!has_several_frames(state) || picture.height - height < lowest_picture * context.scale) {
        state.player.choices.handle_held = false;
        return picture;
    }
    picture.height -= height;
    place_window({picture.x, picture.y + picture.height, picture.width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(timeline_margin * context.scale, padding));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::Begin("##timeline", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    draw_timeline(context, timeline_facts(state), state.player.choices);
    ImGui::End();
    ImGui::PopStyleVar(2);
    return picture;
}

// What the eye sees whose rays are shown: the pixel under the pointer there is the eye's.
void draw_rays_over(ViewerState& state, const PanelContext& context, const RedrawFacts& facts, const Rectangle& picture) {
    RaysInSpace& rays = state.rays;
    RaysFacts shown = facts_of_rays(state, facts.inspection.first);
    shown.picture = facts.seen_by_eye;
    // Above the axes in the corner, where there is room for both; else these give way to the right.
    Rectangle place = picture;
    const float axes = axes_height * context.scale;
    const bool above = place.height - axes >= lowest_rays * context.scale;
    if (state.settings.axes_shown && above) place.height -= axes;
    const RaysAnswer answer = draw_rays_panel(context, shown, rays.choice, place);
    rays.panel = answer.size;
    rays.axes_beside = !above;
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
    const float status_line = std::round(ImGui::GetFrameHeight() + 2.0F * context.scale);
    const bool has_status = whole.y - menu_height - status_line >= lowest_picture * context.scale;
    const float status_height = has_status ? status_line : 0.0F;
    Rectangle picture{0.0F, menu_height, whole.x, std::max(whole.y - menu_height - status_height, 0.0F)};

    const float splitter = whole_pixels(splitter_width, context);
    // A comparison takes the side panel's place: so it covers neither the picture nor the inspector, in which it explains pixels.
    const bool compares = state.comparison && state.comparison->view.open;
    float room = whole.x - splitter - room_beside_panel(state, context, whole.x, compares);
    const bool has_room = room >= narrowest_panel * context.scale;
    // The panel narrows for the number of the frame under the picture, as far as it can be read itself.
    if (has_room && has_several_frames(state)) {
        const float line = least_timeline_width(context, timeline_facts(state)) + 2.0F * timeline_margin * context.scale;
        room = std::min(room, std::max(whole.x - splitter - line, narrowest_panel * context.scale));
    }
    const float covering = std::min(narrowest_under_tool * context.scale, whole.x);
    Rectangle comparison{whole.x - covering, picture.y, covering, picture.height};
    state.panel_drawn = state.panel_shown && has_room && !compares;
    if (has_room && (state.panel_shown || compares)) {
        // A small window or large text narrows the panel for as long as that lasts: what the person chose is kept.
        const double shown = panel_width_within(state.settings.panel_width, room / context.scale);
        const float width = std::floor(std::min(static_cast<float>(shown) * context.scale, room));
        const Rectangle panel{whole.x - width, picture.y, width, picture.height};
        if (compares) {
            comparison = panel;
        } else {
            place_window(panel);
            // The list scrolls in itself, by its own means.
            const ImGuiWindowFlags wheel = state.side_panel.list_hovered ? ImGuiWindowFlags_NoScrollWithMouse : 0;
            ImGui::Begin("##panel", nullptr, fixed_window | wheel);
            draw_side_panel(context, state.side_panel);
            ImGui::End();
        }
        const auto by = static_cast<double>(
            draw_splitter(context, "splitter", {panel.x - splitter, panel.y, splitter, panel.height}) / context.scale);
        if (by != 0.0) state.settings.panel_width = panel_width_range.nearest(shown - by);
        picture.width = std::max(panel.x - splitter, 0.0F);
    }
    if (state.inspector_shown) picture = draw_inspector_beside(state, context, facts, picture);
    picture = draw_timeline_below(state, context, picture);

    if (has_status) {
        place_window({0.0F, whole.y - status_height, whole.x, status_height});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10.0F * context.scale, 1.0F * context.scale));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
        ImGui::Begin("##status", nullptr, fixed_window | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        draw_status_bar(context, facts.status);
        ImGui::End();
        ImGui::PopStyleVar(2);
    }
    ImGui::PopStyleVar(2);

    const CancelledWork cancelled = draw_messages(context, state.messages, picture, state.marks_in_corners);
    if (cancelled.work) cancel_work(state);
    if (cancelled.film) cancel_film(state);
    if (state.is_at_start()) {
        const bool has_keys = state.dialogs.empty() && !state.help_shown && !state.about.shown && !ImGui::GetIO().WantTextInput &&
                              !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
        draw_start_page(context, state.start_page, state.settings.recent, picture, has_keys);
    }
    draw_measuring(context, state.measuring, picture, measured_places(state, picture), places_of_marks(state, picture));
    if (state.rays.on) draw_rays_over(state, context, facts, picture);
    if (compares) {
        const ComparisonWords& words = state.comparison->words;
        const std::optional<PinnedPixel>& pin = state.pins.first;
        const auto pinned = pin && pin->size == words.size ? std::optional(pin->pixel) : std::nullopt;
        draw_comparison(context, words, facts.difference ? &*facts.difference : nullptr, pinned, comparison,
                        state.comparison->view);
    }
    if (state.help_shown) draw_help(context, state.help_shown);
    draw_about(context, state.about, state.options.program.name_and_version, state.options.program.licenses, facts.status.renderer);
    draw_dialogs(context, state.dialogs, facts.keys);
    return picture;
}

}  // namespace sphereview

#include "viewer/view_marks.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/picture_marks.hpp"
#include "base/text.hpp"
#include "camera/navigation.hpp"
#include "camera/projected_line.hpp"
#include "panels/widgets.hpp"
#include "viewer/mouse_control.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

namespace {

constexpr double unit_on_screen = 2.0;  // screen coordinates, at the usual scale

constexpr ImGuiWindowFlags marks_window = quiet_window | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                                          ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string name_of_end(const AxisEnd& end) { return std::string(end.positive ? "+" : "-") + "xyz"[end.axis]; }

void look_along(ViewerState& state, AxisEnd end) {
    CameraAxes axes = axes_seen_from(state.camera, end);
    constexpr double already = 1.0 - 1e-9;
    if (glm::dot(camera_axes(state.camera).ahead, axes.ahead) > already) {
        end.positive = !end.positive;
        axes = axes_seen_from(state.camera, end);
    }
    state.flight.emplace(state.camera, turned_to(state.camera, state.pivot, axes), state.pivot);
}

void turn(ViewerState& state, ImVec2 by, float radius) {
    const double angle = std::numbers::pi / (4.0 * static_cast<double>(radius));
    const auto turned = state.settings.trackball ? tumbled : orbited;
    state.camera = turned(state.camera, state.pivot, static_cast<double>(by.x) * angle, static_cast<double>(by.y) * angle);
}

class AxesOnScreen {
public:
    AxesOnScreen(ViewerState& state, const PanelContext& context, ImVec2 middle, float unit)
        : state_(state), context_(context), middle_(middle), unit_(unit), ends_(axis_ends(state.camera)) {}

    // Returns what is under the pointer.
    std::optional<AxisEnd> take_mouse() {
        const float radius = axes_radius * unit_;
        ImGui::SetNextWindowPos({middle_.x - radius, middle_.y - radius});
        ImGui::SetNextWindowSize({2.0F * radius, 2.0F * radius});
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
        ImGui::Begin("##axes", nullptr, marks_window);
        ImGui::InvisibleButton("##axes", {2.0F * radius, 2.0F * radius});
        note_widget(context_, "axes");
        const std::optional<AxisEnd> end = ImGui::IsItemHovered() ? end_at(ImGui::GetIO().MousePos) : std::nullopt;
        drag(radius);
        if (ImGui::IsItemDeactivated() && !state_.axes_in_hand.turns && end) look_along(state_, *end);
        if (end && !ImGui::IsItemActive()) {
            ImGui::SetTooltip("Look along %c, from %s; drag to turn the view", "xyz"[end->axis], name_of_end(*end).c_str());
        }
        ImGui::End();
        ImGui::PopStyleVar(3);
        for (const AxisEnd& one : ends_) {
            const ImVec2 at = place_of_end(one);
            const float ball = axis_ball * unit_;
            note_rectangle(context_, "axis " + name_of_end(one), {at.x - ball, at.y - ball}, {2.0F * ball, 2.0F * ball});
        }
        return end;
    }

    ImVec2 place_of_end(const AxisEnd& end) const {
        const float length = axis_length * unit_;
        return {middle_.x + static_cast<float>(end.place.x) * length, middle_.y + static_cast<float>(end.place.y) * length};
    }

private:
    // The nearest to the eye of those under the pointer.
    std::optional<AxisEnd> end_at(ImVec2 pointer) const {
        for (auto end = ends_.rbegin(); end != ends_.rend(); ++end) {
            const ImVec2 at = place_of_end(*end);
            if (std::hypot(pointer.x - at.x, pointer.y - at.y) <= axis_ball * unit_) return *end;
        }
        return std::nullopt;
    }

    void drag(float radius) {
        AxesInHand& hand = state_.axes_in_hand;
        if (ImGui::IsItemActivated()) hand = {};
        if (!ImGui::IsItemActive()) return;
        const ImVec2 moved = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0F);
        hand.turns = hand.turns || std::hypot(moved.x, moved.y) > 4.0F * context_.scale;
        if (!hand.turns) return;
        turn(state_, {moved.x - hand.applied.x, moved.y - hand.applied.y}, radius);
        hand.applied = moved;
    }

    ViewerState& state_;
    const PanelContext& context_;
    ImVec2 middle_;
    float unit_;
    std::array<AxisEnd, 6> ends_;
};

// `bar`: how far the scale bar reaches from its corner. Where the axes would lie on it, they stand above.
void draw_axes_on_screen(ViewerState& state, const PanelContext& context, const Rectangle& picture, ImVec2 bar, double pixels,
                         int unit) {
    const float unit_here = static_cast<float>(unit / (stroke_unit * pixels));
    const float away = (axes_radius + marks_margin) * unit_here;
    const float right = state.rays.on && state.rays.axes_beside ? state.rays.panel.x : 0.0F;
    const float up = right + 2.0F * away > picture.width - bar.x ? bar.y : 0.0F;
    const ImVec2 middle{std::round(picture.x + right + away), std::round(picture.y + picture.height - up - away)};
    if (middle.x + away > picture.x + picture.width) return;
    state.marks_in_corners.left = {middle.x + away - picture.x, up + 2.0F * away};
    AxesOnScreen axes(state, context, middle, unit_here);
    const std::optional<AxisEnd> chosen = axes.take_mouse();
    if (chosen) {
        ImGui::GetBackgroundDrawList()->AddCircleFilled(middle, axes_radius * unit_here, IM_COL32(255, 255, 255, 28), 48);
    }
    draw_strokes(strokes_of_axes(state.camera, {0, 0}, unit), middle, pixels);
    if (chosen) {
        ImGui::GetBackgroundDrawList()->AddCircle(axes.place_of_end(*chosen), axis_ball * unit_here, IM_COL32(255, 255, 255, 255),
                                                  32, 0.8F * unit_here);
    }
}

// Letters as large as the window's; those of the axes, in their balls, are larger.
int unit_of_letters(int unit) { return std::max(unit * 2 / 3, 1); }

void draw_scale_bar_on_screen(ViewerState& state, const Rectangle& picture, double pixels, int unit) {
    const double most = longest_scale_bar * state.picture_size.shorter_side();
    const std::optional<ScaleBar> bar = scale_bar(state.camera, state.picture_size, state.pivot, most);
    if (!bar) return;
    const double size = stroke_unit * pixels;  // of an ImGui coordinate
    const float away = 2.0F * marks_margin * static_cast<float>(unit / size);
    const ImVec2 corner{std::round(picture.x + picture.width - away), std::round(picture.y + picture.height - away)};
    const std::vector<Stroke> strokes =
        strokes_of_scale_bar(*bar, {0, 0}, unit_of_letters(unit), state.picture_size.width * stroke_unit / 2);
    draw_strokes(strokes, corner, pixels);
    ImVec2& extent = state.marks_in_corners.right;
    for (const Stroke& stroke : strokes) {
        for (const StrokePlace& at : {stroke.from, stroke.to}) {
            extent.x = std::max(extent.x, away - static_cast<float>(at.x / size));
            extent.y = std::max(extent.y, away - static_cast<float>(at.y / size));
        }
    }
    extent.x += away;
    extent.y += away;
}

void draw_legend_on_screen(ViewerState& state, const Coloring& coloring, const Rectangle& picture, double pixels, int unit) {
    const int width = state.picture_size.width * stroke_unit;
    const LegendRoom room = room_for_legend(width, state.picture_size.height * stroke_unit, unit);
    const std::vector<Stroke> strokes =
        strokes_of_legend(coloring, room, unit_of_letters(unit), is_light(state.shown_background()));
    draw_strokes(strokes, {picture.x, picture.y}, pixels);
    const double size = stroke_unit * pixels;  // of an ImGui coordinate
    ImVec2& extent = state.marks_in_corners.legend;
    for (const Stroke& stroke : strokes) {
        for (const StrokePlace& at : {stroke.from, stroke.to}) {
            extent.x = std::max(extent.x, static_cast<float>((width - at.x) / size));
            extent.y = std::max(extent.y, static_cast<float>(at.y / size));
        }
    }
}

}  // namespace

void draw_view_marks(ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels) {
    const Coloring* coloring = shown_coloring(state.document, state.side_panel.look);  // also for exports and other frames
    const int wanted = static_cast<int>(std::lround(unit_on_screen * static_cast<double>(context.scale) * pixels * stroke_unit));
    const int unit = unit_of_marks(state.picture_size.shorter_side(), wanted);
    const ImVec2 bar = std::exchange(state.marks_in_corners, {}).right;
    if (state.is_at_start() || unit == 0) return;
    if (state.settings.axes_shown) draw_axes_on_screen(state, context, picture, bar, pixels, unit);
    if (state.settings.legend_shown && coloring != nullptr) draw_legend_on_screen(state, *coloring, picture, pixels, unit);
    if (state.settings.scale_bar_shown) draw_scale_bar_on_screen(state, picture, pixels, unit);
}

std::vector<ImVec2> measured_places(const ViewerState& state, const Rectangle& picture) {
    std::vector<ImVec2> places;
    const double pixels = picture.width > 0.0F ? state.picture_size.width / static_cast<double>(picture.width) : 1.0;
    for (const std::uint32_t number : state.measuring.spheres) {
        if (!has_sphere(state.scene(), number)) return {};
        const auto at = place_of(state.camera, state.picture_size, state.scene().spheres[number].center);
        if (at) places.push_back(on_screen(picture, pixels, *at));
    }
    return places;
}

std::vector<Rectangle> places_of_marks(const ViewerState& state, const Rectangle& picture) {
    const CornerMarks& marks = state.marks_in_corners;
    const float right = picture.x + picture.width;
    const float bottom = picture.y + picture.height;
    std::vector<Rectangle> places = {{picture.x, bottom - marks.left.y, marks.left.x, marks.left.y},
                                     {right - marks.right.x, bottom - marks.right.y, marks.right.x, marks.right.y},
                                     {right - marks.legend.x, picture.y, marks.legend.x, marks.legend.y}};
    if (state.rays.on) places.push_back({picture.x, picture.y, state.rays.panel.x, state.rays.panel.y});
    std::erase_if(places, [](const Rectangle& place) { return place.width <= 0.0F; });
    return places;
}

void draw_measured(const ViewerState& state, const PanelContext& context, const Rectangle& picture, double pixels) {
    const Measuring& measuring = state.measuring;
    const std::vector<Sphere>& spheres = state.scene().spheres;
    const std::vector<Measure> measures = measures_of(measuring, state.scene(), !context.view.mirrored);
    if (measuring.spheres.empty() || measuring.spheres.size() > measures.size() + 1) return;
    const OverPicture draw(picture);
    const auto place = [&](std::size_t i) -> std::optional<ImVec2> {
        const auto at = place_of(state.camera, state.picture_size, spheres[measuring.spheres[i]].center);
        return at ? std::optional(on_screen(picture, pixels, *at)) : std::nullopt;
    };
    // To the next: also where one of the two is behind the eye.
    const auto line_from = [&](std::size_t i) -> std::optional<ProjectedLine> {
        if (i + 1 >= measuring.spheres.size()) return std::nullopt;
        return projected_line(state.camera, state.picture_size, spheres[measuring.spheres[i]].center,
                              spheres[measuring.spheres[i + 1]].center);
    };
    constexpr ImU32 dark = IM_COL32(18, 20, 26, 220);
    constexpr ImU32 light = IM_COL32(255, 214, 92, 255);
    const float line = 1.6F * context.scale;
    for (const ImU32 color : {dark, light}) {
        const float more = color == dark ? 1.5F * context.scale : 0.0F;
        for (std::size_t i = 0; i < measuring.spheres.size(); ++i) {
            const auto at = place(i);
            if (const auto shown = line_from(i)) {
                draw->AddLine(on_screen(picture, pixels, shown->from), on_screen(picture, pixels, shown->to), color,
                              line + 2.0F * more);
            }
            if (at) draw->AddCircleFilled(*at, 3.5F * context.scale + more, color, 24);
        }
    }
    for (const Measure& one : measures) {
        if (one.name.starts_with("dihedral")) continue;  // of all of them: the window beside has it
        // In the middle of what is seen of a line.
        const auto shown = one.is_angle ? std::nullopt : line_from(one.middle);
        const auto at = shown          ? std::optional(on_screen(picture, pixels, shown->place_at(0.5)))
                        : one.is_angle ? place(one.middle)
                                       : std::nullopt;
        if (!at) continue;
        const std::string text = value_text(one, 4);
        const float width = width_of(text);
        const float height = ImGui::GetTextLineHeight();
        const float pad = 3.0F * context.scale;
        // Of an angle below its sphere: its distances are above.
        const ImVec2 low{std::round(at->x - 0.5F * width), std::round(at->y + (one.is_angle ? 0.5F : -1.3F) * height)};
        draw->AddRectFilled({low.x - pad, low.y - pad}, {low.x + width + pad, low.y + height + pad},
                            ImGui::GetColorU32(ImGuiCol_PopupBg, 0.92F), pad);
        draw->AddText(low, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    }
}

std::string shown_marks(const ViewerState& state) {
    std::vector<std::string> marks;
    if (state.settings.axes_shown) marks.emplace_back("axes");
    if (state.settings.scale_bar_shown) marks.emplace_back("scale bar");
    if (state.settings.legend_shown && state.side_panel.look.shown) marks.emplace_back("legend");
    return listed(marks, "and");
}

PictureMarks exported_marks(const ViewerState& state) {
    if (!state.settings.marks_exported) return {};
    const LookPanelState& look = state.side_panel.look;
    const bool has_legend = state.settings.legend_shown && look.shown_revision == state.document.revision();
    return {state.settings.axes_shown, state.settings.scale_bar_shown, state.pivot, has_legend ? look.shown : std::nullopt,
            is_light(state.shown_background())};
}

void draw_strokes(std::span<const Stroke> strokes, ImVec2 origin, double pixels) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const double size = 1.0 / (stroke_unit * pixels);
    for (const Stroke& stroke : strokes) {
        const auto place = [&](StrokePlace at) {
            return ImVec2(origin.x + static_cast<float>(at.x * size), origin.y + static_cast<float>(at.y * size));
        };
        const ImU32 color = IM_COL32(stroke.color[0], stroke.color[1], stroke.color[2], 255);
        const auto width = static_cast<float>(stroke.width * size);
        const ImVec2 from = place(stroke.from);
        const ImVec2 to = place(stroke.to);
        draw.AddCircleFilled(from, 0.5F * width, color);
        if (stroke.from.x == stroke.to.x && stroke.from.y == stroke.to.y) continue;
        draw.AddLine(from, to, color, width);
        draw.AddCircleFilled(to, 0.5F * width, color);
    }
}

namespace {

// A light rectangle beside a dark one, which are seen on every colour, and a light veil inside; each of an opacity up to 255.
void draw_border(const Rectangle& picture, ImVec2 low, ImVec2 high, int dark, int light, int inside = 0) {
    const OverPicture draw(picture);
    draw->AddRectFilled(low, high, IM_COL32(255, 255, 255, inside));
    draw->AddRect(ImVec2(low.x - 1.0F, low.y - 1.0F), ImVec2(high.x + 1.0F, high.y + 1.0F), IM_COL32(0, 0, 0, dark));
    draw->AddRect(low, high, IM_COL32(255, 255, 255, light));
}

// Small and light, with a dark edge.
void draw_cross(const Rectangle& picture, ImVec2 middle, float scale) {
    const OverPicture draw(picture);
    const auto bars = [&](float length, float thickness, ImU32 color) {
        const ImVec2 along(length * scale, 0.5F * thickness * scale);
        draw->AddRectFilled(ImVec2(middle.x - along.x, middle.y - along.y), ImVec2(middle.x + along.x, middle.y + along.y), color);
        draw->AddRectFilled(ImVec2(middle.x - along.y, middle.y - along.x), ImVec2(middle.x + along.y, middle.y + along.x), color);
    };
    bars(9.0F, 4.0F, IM_COL32(0, 0, 0, 170));
    bars(8.0F, 2.0F, IM_COL32(255, 255, 255, 230));
}

// With a name beside it.
void draw_named_pin(const Rectangle& picture, ImVec2 place, float scale, const char* name) {
    const OverPicture draw(picture);
    const ImVec2 middle(std::floor(place.x) + 0.5F, std::floor(place.y) + 0.5F);
    draw_pin(draw.list(), middle, 13.0F, scale);
    const ImVec2 beside(middle.x + 8.0F * scale, middle.y + 6.0F * scale);
    draw->AddText(ImVec2(beside.x + 1.0F, beside.y + 1.0F), IM_COL32(0, 0, 0, 220), name);
    draw->AddText(beside, pin_color, name);
}

}  // namespace

ImVec2 on_screen(const Rectangle& picture, double pixels, const glm::dvec2& place) {
    return {picture.x + static_cast<float>(place.x / pixels), picture.y + static_cast<float>(place.y / pixels)};
}

void draw_pointer_marks(const ViewerState& state, const MouseControl& mouse, const Rectangle& picture, double pixels, float scale) {
    const auto at = [&](const glm::dvec2& place) { return on_screen(picture, pixels, place); };
    if (const auto box = mouse.box()) {
        draw_border(picture, at(glm::min(box->from, box->to)), at(glm::max(box->from, box->to)), 160, 220, 40);
    }
    if (const auto point = mouse.turns_about()) {
        const auto place = place_of(state.camera, state.picture_size, *point);
        if (place) draw_cross(picture, at(*place), scale);
    }
    if (!state.inspector_shown || state.rays.on) return;
    for (const auto& [pixel, name] : {std::pair{&state.pins.first, "1"}, std::pair{&state.pins.second, "2"}}) {
        if (*pixel) draw_named_pin(picture, at(place_in(state.picture_size, **pixel)), scale, state.pins.second ? name : "");
    }
}

void draw_export_area(const ViewerState& state, const Rectangle& picture) {
    if (!state.export_area_shown || state.rays.on || state.is_at_start()) return;
    const PictureSize size{state.settings.export_width, state.settings.export_height};
    // Both show `right` and `up` over half their shorter side.
    const float unit = 0.5F * std::min(picture.width, picture.height) / static_cast<float>(size.shorter_side());
    const float half_width = unit * static_cast<float>(size.width);
    const float half_height = unit * static_cast<float>(size.height);
    if (half_width > 0.5F * picture.width - 1.0F && half_height > 0.5F * picture.height - 1.0F) return;
    const ImVec2 middle(picture.x + 0.5F * picture.width, picture.y + 0.5F * picture.height);
    const ImVec2 low(std::floor(middle.x - half_width), std::floor(middle.y - half_height));
    const ImVec2 high(std::ceil(middle.x + half_width), std::ceil(middle.y + half_height));
    draw_border(picture, low, high, 140, 90);
}

}  // namespace sphereview

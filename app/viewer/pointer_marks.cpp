#include "viewer/pointer_marks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "panels/widgets.hpp"
#include "viewer/mouse_control.hpp"
#include "viewer/viewer_state.hpp"

namespace sphereview {

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

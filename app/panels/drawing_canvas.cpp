#include "panels/drawing_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "panels/math_text.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

ImU32 faded(const ImVec4& color, float opacity) {
    return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, color.w * opacity});
}

ImU32 text_color(float opacity) { return faded(ImGui::GetStyleColorVec4(ImGuiCol_Text), opacity); }

ImVec4 line_color(const Scene& scene, std::int32_t number) {
    const float least = is_light_theme() ? 0.0F : 0.32F;
    const float most = is_light_theme() ? 0.55F : 1.0F;
    const Color& color = scene.spheres[static_cast<std::size_t>(number)].color;
    const auto part = [&](std::uint8_t byte) { return least + (most - least) * static_cast<float>(byte) / 255.0F; };
    return {part(color.r), part(color.g), part(color.b), 1.0F};
}

Canvas::Canvas(const PanelContext& context, const char* name, float height_by_width, const SectionWindow& window)
    : context_(context), name_(name), window_(window), scale_(context.scale), low_(ImGui::GetCursorScreenPos()) {
    size_.x = std::max(ImGui::GetContentRegionAvail().x, 40.0F * scale_);
    size_.y = std::floor(height_by_width * size_.x);
    ImGui::PushID(name);
    clicked_ = ImGui::InvisibleButton("##drawing", size_);
    ImGui::PopID();
    hovered_ = ImGui::IsItemHovered();
    note_widget(context, name);
    list_ = ImGui::GetWindowDrawList();
    list_->AddRectFilled(low_, high(), is_light_theme() ? IM_COL32(255, 255, 255, 200) : IM_COL32(0, 0, 0, 60), 4.0F * scale_);
    list_->PushClipRect(low_, high(), true);
}

Canvas::~Canvas() {
    draw_texts();
    list_->PopClipRect();
    list_->AddRect(low_, high(), ImGui::GetColorU32(ImGuiCol_Border), 4.0F * scale_);
}

ImVec2 Canvas::at(const glm::dvec2& place) const {
    const glm::dvec2 part = (place - window_.low) / (window_.high - window_.low);
    const auto within = [](double value) { return static_cast<float>(std::clamp(value, -50.0, 50.0)); };
    return {low_.x + within(part.x) * size_.x, low_.y + (1.0F - within(part.y)) * size_.y};
}

glm::dvec2 Canvas::place_of(ImVec2 point) const {
    const double x = static_cast<double>((point.x - low_.x) / size_.x);
    const double y = 1.0 - static_cast<double>((point.y - low_.y) / size_.y);
    return window_.low + glm::dvec2(x, y) * (window_.high - window_.low);
}

void Canvas::line(const glm::dvec2& from, const glm::dvec2& to, ImU32 color, float thickness) const {
    list_->AddLine(at(from), at(to), color, thickness * scale_);
}

void Canvas::dashes(const glm::dvec2& from, const glm::dvec2& to, ImU32 color, float thickness) const {
    const ImVec2 a = at(from);
    const ImVec2 b = at(to);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const float dash = 4.0F * scale_;
    constexpr float most = 1500.0F;  // of a line that leads far away
    for (float along = 0.0F; along < std::min(length, most * dash); along += 2.0F * dash) {
        const auto point = [&](float on) {
            const float part = std::min(on / length, 1.0F);
            return ImVec2(a.x + part * (b.x - a.x), a.y + part * (b.y - a.y));
        };
        list_->AddLine(point(along), point(along + dash), color, thickness * scale_);
    }
}

void Canvas::curve(const std::vector<glm::dvec2>& points, ImU32 color, float thickness, bool dashed) const {
    const std::vector<ImVec2> places = places_of(points);
    if (!dashed) {
        list_->AddPolyline(places.data(), static_cast<int>(places.size()), color, 0, thickness * scale_);
        return;
    }
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) list_->AddLine(places[i], places[i + 1], color, thickness * scale_);
}

void Canvas::fill(const std::vector<glm::dvec2>& points, ImU32 color) const {
    const std::vector<ImVec2> places = places_of(points);
    list_->AddConvexPolyFilled(places.data(), static_cast<int>(places.size()), color);
}

void Canvas::point(const glm::dvec2& place, float radius, ImU32 color, bool filled) {
    const ImVec2 middle = at(place);
    // What lies below shines through no point.
    list_->AddCircleFilled(middle, radius * scale_, ImGui::GetColorU32(ImGuiCol_WindowBg));
    if (filled) list_->AddCircleFilled(middle, radius * scale_, color);
    list_->AddCircle(middle, radius * scale_, filled ? text_color(1.0F) : color, 0, 1.5F * scale_);
    keep_free(middle, radius);
}

void Canvas::keep_free(ImVec2 middle, float radius) {
    const float half = 0.7F * radius * scale_;  // the square in the disc: a corner beside it covers nothing
    const Box box{{middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}};
    note_rectangle(context_, name_ + " mark " + std::to_string(taken_.size()), box.low, {2.0F * half, 2.0F * half});
    taken_.push_back(box);
}

void Canvas::text(ImVec2 place, float across, float down, const std::string& words, ImU32 color, Importance importance) {
    texts_.push_back({place, across, down, in_glyphs(words), color, importance});
}

void Canvas::draw_texts() {
    std::ranges::stable_sort(texts_, {}, &Text::importance);
    const float margin = 3.0F * scale_;
    for (const Text& text : texts_) {
        const ImVec2 size = ImGui::CalcTextSize(text.words.c_str());
        if (size.x > size_.x - 2.0F * margin || size.y > size_.y - 2.0F * margin) continue;
        const auto at = [&](float across, float down, float lines) {
            const auto inside = [&](float wanted, float low, float high, float extent) {
                return std::round(std::max(std::min(wanted, high - extent - margin), low + margin));
            };
            const ImVec2 corner{inside(text.place.x - across * size.x, low_.x, high().x, size.x),
                                inside(text.place.y + (lines - down) * size.y, low_.y, high().y, size.y)};
            return Box{{corner.x - 2.0F * scale_, corner.y}, {corner.x + size.x + 2.0F * scale_, corner.y + size.y}};
        };
        const auto is_free = [&](const Box& place) {
            return std::ranges::none_of(taken_, [&](const Box& other) { return place.overlaps(other); });
        };
        std::optional<Box> found;
        for (const float lines : {0.0F, 1.0F, -1.0F}) {
            for (const float across : {text.across, 1.0F - text.across}) {
                for (const float down : {text.down, 1.0F - text.down}) {
                    const Box place = at(across, down, lines);
                    if (!found && is_free(place)) found = place;
                }
            }
        }
        if (!found) continue;
        taken_.push_back(*found);
        list_->AddRectFilled(found->low, found->high, faded(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg), 0.62F), 2.0F * scale_);
        list_->AddText({found->low.x + 2.0F * scale_, found->low.y}, text.color, text.words.c_str());
        note_rectangle(context_, name_ + " text " + text.words, found->low, {found->high.x - found->low.x, size.y});
    }
}

void Canvas::cross(const glm::dvec2& place, float reach, ImU32 color, float thickness) const {
    const ImVec2 p = at(place);
    const float r = reach * scale_;
    list_->AddLine({p.x - r, p.y - r}, {p.x + r, p.y + r}, color, thickness * scale_);
    list_->AddLine({p.x - r, p.y + r}, {p.x + r, p.y - r}, color, thickness * scale_);
}

std::vector<ImVec2> Canvas::places_of(const std::vector<glm::dvec2>& points) const {
    std::vector<ImVec2> places;
    places.reserve(points.size());
    for (const glm::dvec2& point : points) places.push_back(at(point));
    return places;
}

}  // namespace sphereview

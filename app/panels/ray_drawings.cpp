#include "panels/ray_drawings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "panels/math_text.hpp"
#include "panels/ray_section.hpp"
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

namespace {

class PlotDrawing {
public:
    PlotDrawing(Canvas& canvas, const QuadraticPlot& plot, const Scene& scene) : canvas_(canvas), plot_(plot), scene_(scene) {}

    void draw() const {
        draw_axes();
        for (auto curve = plot_.curves.rbegin(); curve != plot_.curves.rend(); ++curve) draw_curve(*curve);
        draw_lowest();
        draw_zeros();
    }

    const QuadraticCurve* under_mouse() const {
        if (!canvas_.hovered()) return nullptr;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const double t = canvas_.place_of(mouse).x;
        for (const QuadraticCurve& curve : plot_.curves) {
            // Near it beside or above: it may be steep.
            const double slack = canvas_.pixels(5.0F);
            const auto y = [&](double at) { return canvas_.at({at, curve.at(at)}).y; };
            const auto [low, high] = std::minmax({y(t - slack), y(t), y(t + slack)});
            if (mouse.y >= low - 5.0F * canvas_.scale() && mouse.y <= high + 5.0F * canvas_.scale()) return &curve;
        }
        return nullptr;
    }

private:
    void draw_axes() const {
        const float s = canvas_.scale();
        if (plot_.left < 0.0) {  // what lies behind the eye
            canvas_.list().AddRectFilled(canvas_.low(), {canvas_.at({0.0, 0.0}).x, canvas_.high().y}, text_color(0.05F));
        }
        canvas_.line({plot_.left, 0.0}, {plot_.right, 0.0}, text_color(0.6F), 1.0F);
        const float y = canvas_.at({0.0, 0.0}).y;
        canvas_.text({canvas_.high().x - 4.0F * s, y - 3.0F * s}, 1.0F, 1.0F, "t", text_color(0.85F), Importance::some);
        if (!plot_.shows_origin) return;
        canvas_.line({0.0, plot_.bottom}, {0.0, plot_.top}, text_color(0.35F), 1.0F);
        canvas_.text({canvas_.at({0.0, 0.0}).x + 3.0F * s, canvas_.high().y - 3.0F * s}, 0.0F, 1.0F, "t = 0", text_color(0.6F),
                     Importance::least);
    }

    void draw_curve(const QuadraticCurve& curve) const {
        if (!has_sphere(scene_, curve.number)) return;
        const bool subject = &curve == plot_.curves.data();
        // From where it comes into the plot to where it leaves it.
        const double reach = std::sqrt(std::max(plot_.top + 0.3 * (plot_.top - plot_.bottom) - curve.lowest, 0.0));
        const double left = std::max(curve.lowest_t - reach, plot_.left);
        const double right = std::min(curve.lowest_t + reach, plot_.right);
        if (!(left < right)) return;
        constexpr int steps = 96;
        std::vector<glm::dvec2> points;
        for (int i = 0; i <= steps; ++i) {
            const double t = left + (right - left) * i / steps;
            points.emplace_back(t, curve.at(t));
        }
        canvas_.curve(points, faded(line_color(scene_, curve.number), subject ? 1.0F : 0.45F), subject ? 2.2F : 1.2F);
    }

    // How far the lowest point is from the axis: the discriminant.
    void draw_lowest() const {
        const QuadraticCurve& curve = plot_.curves.front();
        const ImU32 color = faded(color_of_sign(curve.sign), 1.0F);
        const glm::dvec2 lowest{curve.lowest_t, curve.lowest};
        const float s = canvas_.scale();
        canvas_.line({curve.lowest_t, 0.0}, lowest, color, 2.0F);
        canvas_.point(lowest, 3.5F, color, false);
        const ImVec2 at = canvas_.at(lowest);
        if (curve.sign >= 0) {
            canvas_.text({at.x, at.y + 6.0F * s}, 0.5F, 0.0F,
                         curve.sign > 0 ? "−(b² − 4ac) / 4a, below 0" : "b² − 4ac = 0: it touches", color, Importance::more);
        } else {
            const ImVec2 middle = canvas_.at(0.5 * (lowest + glm::dvec2(curve.lowest_t, 0.0)));
            canvas_.text({middle.x + 7.0F * s, middle.y}, 0.0F, 0.5F, "−(b² − 4ac) / 4a, above 0", color, Importance::more);
        }
    }

    void draw_zeros() const {
        for (auto curve = plot_.curves.rbegin(); curve != plot_.curves.rend(); ++curve) {
            if (curve->sign < 0 || !has_sphere(scene_, curve->number)) continue;
            const bool subject = &*curve == plot_.curves.data();
            const ImU32 color = faded(line_color(scene_, curve->number), subject ? 1.0F : 0.6F);
            canvas_.point({curve->t2, 0.0}, subject ? 5.0F : 3.0F, color, curve->second_counts);
            canvas_.point({curve->t1, 0.0}, subject ? 5.0F : 3.0F, color, curve->first_counts);
        }
        const QuadraticCurve& curve = plot_.curves.front();
        if (curve.sign <= 0) return;
        const int digits = std::min(digits_to_tell(curve.t1, curve.t2), 9);
        const auto label = [&](double t, const char* name, float across) {
            const ImVec2 at = canvas_.at({t, 0.0});
            if (at.x < canvas_.low().x || at.x > canvas_.high().x) return;
            const float aside = (across > 0.5F ? -6.0F : 6.0F) * canvas_.scale();
            canvas_.text({at.x + aside, at.y - 4.0F * canvas_.scale()}, across, 1.0F, name + number_text(t, digits),
                         text_color(0.95F), Importance::most);
        };
        label(curve.t1, "t₁ = ", 1.0F);
        label(curve.t2, "t₂ = ", 0.0F);
    }

    Canvas& canvas_;
    const QuadraticPlot& plot_;
    const Scene& scene_;
};

}  // namespace

std::optional<std::int32_t> draw_quadratic_plot(const PanelContext& context, const char* name, const PixelExplanation& explanation,
                                                std::int32_t subject) {
    const Scene& scene = context.document.scene();
    const QuadraticPlot plot = plot_of(explanation, subject);
    if (plot.curves.empty() || !has_sphere(scene, plot.curves.front().number)) return std::nullopt;
    Canvas canvas(context, name, 0.42F, {{plot.left, plot.bottom}, {plot.right, plot.top}});
    const PlotDrawing drawing(canvas, plot, scene);
    drawing.draw();
    const QuadraticCurve* const curve = drawing.under_mouse();
    if (curve == nullptr || !has_sphere(scene, curve->number)) return std::nullopt;
    show_numbers(scene, explanation, curve->number, behind_in_words(explanation));
    return canvas.clicked() ? std::optional(curve->number) : std::nullopt;
}

}  // namespace sphereview

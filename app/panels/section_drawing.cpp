#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/number.hpp"
#include "base/text.hpp"
#include "panels/math_text.hpp"
#include "panels/ray_drawings.hpp"
#include "panels/widgets.hpp"

namespace sphereview {

namespace {

ImVec4 screen_color() { return on_panel({0.36F, 0.62F, 0.95F, 1.0F}); }
ImVec4 sun_color() { return on_panel({0.98F, 0.80F, 0.30F, 1.0F}); }

void draw_length(Canvas& canvas) {
    const double width = canvas.window().high.x - canvas.window().low.x;
    if (!std::isfinite(width) || !(width > 0.0)) return;
    const double length = round_number_below(0.25 * width);
    if (!(length > 0.0)) return;
    const float pixels = static_cast<float>(length / width) * (canvas.high().x - canvas.low().x);
    const float s = canvas.scale();
    // Below, or above where the ray is there.
    const float height = 2.0F * ImGui::GetTextLineHeight();
    const bool above = std::fabs(canvas.at({0.0, 0.0}).y - canvas.high().y) < height;
    const ImVec2 end{canvas.high().x - 8.0F * s, above ? canvas.low().y + height : canvas.high().y - 8.0F * s};
    const ImVec2 begin{end.x - pixels, end.y};
    const ImU32 color = text_color(0.55F);
    canvas.list().AddLine(begin, end, color, 1.5F * s);
    for (const ImVec2& tip : {begin, end})
        canvas.list().AddLine({tip.x, tip.y - 3.0F * s}, {tip.x, tip.y + 3.0F * s}, color, 1.5F * s);
    canvas.text({end.x, end.y - 5.0F * s}, 1.0F, 1.0F, number_text(length), color, Importance::least);
}

class SectionDrawing {
public:
    SectionDrawing(Canvas& canvas, const RaySection& section, const SectionSubject& of)
        : canvas_(canvas), section_(section), of_(of) {}

    void draw() const {
        draw_sight();
        for (auto circle = section_.circles.rbegin(); circle != section_.circles.rend(); ++circle) draw_circle(*circle);
        draw_screen();
        draw_ray();
        draw_gap();
        draw_normal();
        draw_sun();
        draw_roots();
        draw_eye();
        draw_outside();
        draw_length(canvas_);
    }

    // The smallest circle under the mouse.
    const SectionCircle* under_mouse() const {
        if (!canvas_.hovered()) return nullptr;
        const glm::dvec2 place = canvas_.place_of(ImGui::GetIO().MousePos);
        const SectionCircle* found = nullptr;
        for (const SectionCircle& circle : section_.circles) {
            if (glm::distance(place, circle.center) > circle.radius + canvas_.pixels(3.0F)) continue;
            if (found == nullptr || circle.radius < found->radius) found = &circle;
        }
        return found;
    }

private:
    ImVec4 color_of(const SectionCircle& circle) const { return line_color(of_.scene, circle.number); }
    bool is_subject(const SectionCircle& circle) const { return section_.has_subject && &circle == section_.circles.data(); }

    // What the screen's edges let through.
    void draw_sight() const {
        if (!section_.screen || section_.eye_plane) return;
        for (const glm::dvec2& edge : {section_.screen->from, section_.screen->to}) {
            canvas_.line(glm::dvec2(0.0), 40.0 * edge, text_color(0.10F), 1.0F);
        }
    }

    void draw_circle(const SectionCircle& circle) const {
        const bool hit = circle.first_counts || circle.second_counts;
        const bool blocks = circle.number == section_.blocker;
        const float strength = is_subject(circle) ? 1.0F : hit || blocks ? 0.75F : 0.5F;
        const std::vector<glm::dvec2> points = points_of(circle, canvas_.window());
        if (circle.cut) canvas_.fill(points, faded(color_of(circle), 0.16F * strength));
        canvas_.curve(points, faded(color_of(circle), strength), is_subject(circle) ? 2.0F : 1.5F, !circle.cut);
    }

    void draw_screen() const {
        if (section_.screen) {
            canvas_.line(section_.screen->from, section_.screen->to, faded(screen_color(), 1.0F), 2.0F);
            draw_name(*section_.screen, "screen", screen_color());
        }
        if (section_.eye_plane) {
            canvas_.dashes(section_.eye_plane->from, section_.eye_plane->to, text_color(0.6F), 1.5F);
            draw_name(*section_.eye_plane, "eye's plane", ImGui::GetStyleColorVec4(ImGuiCol_Text));
        }
    }

    // At the upper end, or where the drawing ends.
    void draw_name(const SectionLine& line, const char* name, const ImVec4& color) const {
        const ImVec2 a = canvas_.at(line.from);
        const ImVec2 b = canvas_.at(line.to);
        const ImVec2 upper = a.y < b.y ? a : b;
        const ImVec2 lower = a.y < b.y ? b : a;
        if (lower.y - upper.y <= 0.0F) return;
        const float height = ImGui::GetTextLineHeight() + 2.0F * canvas_.scale();
        const float y = std::max(upper.y, canvas_.low().y + height);
        const float x = upper.x + (lower.x - upper.x) * (y - upper.y) / (lower.y - upper.y);
        if (x < canvas_.low().x || x > canvas_.high().x || y > canvas_.high().y) return;
        canvas_.text({x, y}, 0.5F, 1.0F, name, faded(color, 0.9F), Importance::some);
    }

    void draw_ray() const {
        const double left = std::min(canvas_.window().low.x, 0.0);
        const double right = canvas_.window().high.x;
        canvas_.dashes({left, 0.0}, {0.0, 0.0}, text_color(0.35F), 1.0F);
        const double seen = section_.seen.value_or(right);
        canvas_.line({0.0, 0.0}, {seen, 0.0}, of_.from_eye ? text_color(0.95F) : faded(sun_color(), 0.95F), 1.8F);
        if (seen < right) canvas_.line({seen, 0.0}, {right, 0.0}, text_color(0.35F), 1.0F);
        // The arrow that D is.
        if (!section_.screen_outside && section_.screen) arrow({0.0, 0.0}, {section_.on_screen, 0.0}, text_color(0.95F));
    }

    void arrow(const glm::dvec2& from, const glm::dvec2& to, ImU32 color) const {
        const ImVec2 a = canvas_.at(from);
        const ImVec2 b = canvas_.at(to);
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        const float size = 7.0F * canvas_.scale();
        if (length < size) return;
        const ImVec2 along{(b.x - a.x) / length * size, (b.y - a.y) / length * size};
        canvas_.list().AddTriangleFilled(b, {b.x - along.x - 0.45F * along.y, b.y - along.y + 0.45F * along.x},
                                         {b.x - along.x + 0.45F * along.y, b.y - along.y - 0.45F * along.x}, color);
    }

    // By how much the ray passes the subject.
    void draw_gap() const {
        if (!section_.has_subject || section_.circles.front().met) return;
        const SectionCircle& circle = section_.circles.front();
        const double side = circle.center.y < 0.0 ? -1.0 : 1.0;
        const glm::dvec2 foot{circle.center.x, 0.0};
        const glm::dvec2 edge{circle.center.x, circle.center.y - side * circle.radius};
        canvas_.dashes(edge, circle.center, text_color(0.45F), 1.0F);
        canvas_.line(foot, edge, faded(color_of_sign(-1), 1.0F), 2.0F);
        canvas_.point(foot, 3.0F, faded(color_of_sign(-1), 1.0F), false);
        // On the ray's other side, where it covers nothing of the sphere.
        const ImVec2 at = canvas_.at(foot);
        canvas_.text({at.x, at.y + static_cast<float>(side) * 6.0F * canvas_.scale()}, 0.5F, side > 0.0 ? 0.0F : 1.0F,
                     "misses by " + number_text(side * edge.y, 3), faded(color_of_sign(-1), 1.0F), Importance::most);
    }

    // From the centre to the hit.
    void draw_normal() const {
        if (!section_.has_subject) return;
        const SectionCircle& circle = section_.circles.front();
        if (!canvas_.window().holds(circle.center)) return;
        canvas_.cross(circle.center, 3.0F, text_color(0.7F), 1.2F);
        canvas_.keep_free(canvas_.at(circle.center), 3.0F);
        if (circle.first_counts || circle.second_counts) {
            const double hit = circle.first_counts ? circle.first : circle.second;
            canvas_.dashes(circle.center, {hit, 0.0}, text_color(0.5F), 1.0F);
        }
        const ImVec2 at = canvas_.at(circle.center);
        const float below = circle.center.y < 0.0 ? 1.0F : -1.0F;
        canvas_.text({at.x + 5.0F * canvas_.scale(), at.y + below * 5.0F * canvas_.scale()}, 0.0F, below > 0.0F ? 0.0F : 1.0F, "C",
                     text_color(0.85F), Importance::more);
    }

    void draw_sun() const {
        if (!section_.to_sun) return;
        const auto [from, to] = *section_.to_sun;
        canvas_.line(from, to, faded(sun_color(), 0.95F), 1.6F);
        const bool blocked = section_.blocker.has_value();
        if (blocked) {
            canvas_.cross(to, 5.0F, faded(color_of_sign(-1), 1.0F), 2.0F);
        } else {
            arrow(from, to, faded(sun_color(), 0.95F));
        }
        // Named where it is still in the drawing.
        const ImVec2 a = canvas_.at(from);
        const ImVec2 b = canvas_.at(to);
        const float length = std::hypot(b.x - a.x, b.y - a.y);
        if (blocked || length < 60.0F * canvas_.scale()) return;
        const float on = std::min(length, 46.0F * canvas_.scale()) / length;
        canvas_.text({a.x + on * (b.x - a.x) + 6.0F * canvas_.scale(), a.y + on * (b.y - a.y)}, 0.0F, 0.5F,
                     "to the " + std::string(of_.name_of_sun), faded(sun_color(), 0.95F), Importance::some);
    }

    void draw_roots() const {
        for (auto circle = section_.circles.rbegin(); circle != section_.circles.rend(); ++circle) {
            if (!circle->met) continue;
            const ImU32 color = faded(color_of(*circle), is_subject(*circle) ? 1.0F : 0.8F);
            const float size = is_subject(*circle) ? 5.0F : 3.5F;
            canvas_.point({circle->second, 0.0}, size, color, circle->second_counts);
            canvas_.point({circle->first, 0.0}, size, color, circle->first_counts);
        }
        if (!section_.has_subject || !section_.circles.front().met) return;
        const SectionCircle& circle = section_.circles.front();
        const float s = canvas_.scale();
        // On the side of the ray where the centre is not.
        const float down = circle.center.y > 0.0 ? 0.0F : 1.0F;
        const float aside = (circle.center.y > 0.0 ? 1.0F : -1.0F) * 5.0F * s;
        const auto label = [&](double x, float across, const char* name, bool counts) {
            const ImVec2 at = canvas_.at({x, 0.0});
            if (at.x < canvas_.low().x || at.x > canvas_.high().x) return;
            canvas_.text({at.x + (across > 0.5F ? -3.0F : 3.0F) * s, at.y + aside}, across, down, name,
                         text_color(counts ? 1.0F : 0.7F), counts ? Importance::most : Importance::more);
        };
        if (circle.first == circle.second) return label(circle.first, 1.0F, "t₁ = t₂", true);
        label(circle.first, 1.0F, "t₁", circle.first_counts);
        label(circle.second, 0.0F, "t₂", circle.second_counts);
    }

    void draw_eye() const {
        if (section_.eye_outside) return;
        const float s = canvas_.scale();
        canvas_.point(glm::dvec2(0.0), 4.0F, text_color(1.0F), true);
        const ImVec2 at = canvas_.at(glm::dvec2(0.0));
        const char* name = !of_.from_eye ? "P" : section_.eye_plane ? "O" : "eye";
        canvas_.text({at.x - 2.0F * s, at.y + 7.0F * s}, 0.5F, 0.0F, name, text_color(1.0F), Importance::most);
        if (of_.from_eye) return;
        const ImVec2 sun{canvas_.high().x - 12.0F * s, at.y};
        canvas_.list().AddCircleFilled(sun, 6.0F * s, faded(sun_color(), 1.0F));
        canvas_.keep_free(sun, 6.0F);
        canvas_.text({sun.x - 10.0F * s, sun.y - 3.0F * s}, 1.0F, 1.0F, of_.name_of_sun, faded(sun_color(), 1.0F),
                     Importance::some);
    }

    void draw_outside() const {
        const float s = canvas_.scale();
        const float middle = canvas_.at({0.0, 0.0}).y;
        if (section_.eye_outside) {
            const ImVec2 tip{canvas_.low().x + 5.0F * s, middle};
            canvas_.list().AddTriangleFilled(tip, {tip.x + 8.0F * s, tip.y - 5.0F * s}, {tip.x + 8.0F * s, tip.y + 5.0F * s},
                                             text_color(0.95F));
            const std::string what = !of_.from_eye ? "P" : section_.screen_outside ? "eye and screen" : "eye";
            canvas_.text({tip.x, tip.y + 8.0F * s}, 0.0F, 0.0F,
                         what + ", " + number_text(std::fabs(canvas_.window().low.x), 3) + " away", text_color(0.85F),
                         Importance::more);
        }
        if (section_.outside.empty()) return;
        const std::string words =
            section_.outside.size() == 1 ? title_of(of_.scene, section_.outside[0]) : counted(section_.outside.size(), "sphere");
        canvas_.text({canvas_.low().x + 4.0F * s, canvas_.high().y - 4.0F * s}, 0.0F, 1.0F, "outside: " + words, text_color(0.6F),
                     Importance::least);
    }

    Canvas& canvas_;
    const RaySection& section_;
    const SectionSubject& of_;
};

}  // namespace

ImVec4 color_of_sign(int sign) {
    if (sign > 0) return on_panel({0.40F, 0.85F, 0.45F, 1.0F});
    return on_panel(sign == 0 ? ImVec4{1.00F, 0.75F, 0.25F, 1.0F} : ImVec4{1.00F, 0.42F, 0.40F, 1.0F});
}

void show_numbers(const Scene& scene, const PixelExplanation& e, std::int32_t number, const std::string& behind) {
    std::string text = title_of(scene, number);
    const auto hit = std::ranges::find(e.hits, number, &ExplainedHit::number);
    const auto passed = std::ranges::find(e.passed, number, &SphereOnLine::number);
    if (hit != e.hits.end()) {
        text += "\nt₁ = " + shortest(hit->t1) + "\nt₂ = " + shortest(hit->t2);
    } else if (passed != e.passed.end() && passed->discriminant_sign >= 0) {
        text += "\n" + behind + "\nt₁ = " + shortest(passed->t1) + "\nt₂ = " + shortest(passed->t2);
    } else if (passed != e.passed.end()) {
        text += "\nmissed: discriminant = " + shortest(passed->discriminant);
    }
    ImGui::SetTooltip("%s", in_glyphs(text).c_str());
}

std::optional<std::int32_t> draw_ray_section(const PanelContext& context, const char* name, const SectionSubject& of,
                                             std::optional<std::int32_t> subject) {
    constexpr float height_by_width = 0.56F;
    const RaySection section = section_of(of, subject, 1.0 / static_cast<double>(height_by_width));
    Canvas canvas(context, name, height_by_width, section.window);
    const SectionDrawing drawing(canvas, section, of);
    drawing.draw();
    const SectionCircle* const circle = drawing.under_mouse();
    if (circle == nullptr) return std::nullopt;
    show_numbers(of.scene, of.explanation, circle->number, of.from_eye ? behind_in_words(of.explanation) : "behind P");
    return canvas.clicked() ? std::optional(circle->number) : std::nullopt;
}

}  // namespace sphereview

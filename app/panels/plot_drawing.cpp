#include <algorithm>
#include <cmath>

#include "panels/drawing_canvas.hpp"
#include "panels/math_text.hpp"
#include "panels/quadratic_plot.hpp"
#include "panels/ray_drawings.hpp"

namespace sphereview {

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

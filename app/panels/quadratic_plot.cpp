#include "panels/quadratic_plot.hpp"

#include <algorithm>
#include <cmath>

namespace sphereview {

namespace {

// `numbers`: of a hit, or of a sphere that is passed.
QuadraticCurve curve_of(const auto& numbers) {
    QuadraticCurve curve{.number = numbers.number, .lowest_t = -0.5 * numbers.b / numbers.a, .sign = numbers.discriminant_sign};
    const double half = 0.5 * std::sqrt(std::fabs(numbers.discriminant)) / numbers.a;
    curve.lowest = curve.sign > 0 ? -half * half : half * half;
    if (curve.sign >= 0) {
        curve.t1 = numbers.t1;
        curve.t2 = numbers.t2;
    }
    return curve;
}

bool is_finite(const QuadraticCurve& curve) {
    return std::isfinite(curve.lowest_t) && std::isfinite(curve.lowest) && std::isfinite(curve.t1) && std::isfinite(curve.t2);
}

}  // namespace

QuadraticPlot plot_of(const PixelExplanation& explanation, std::int32_t subject) {
    QuadraticPlot plot;
    for (const ExplainedHit& hit : explanation.hits) {
        plot.curves.push_back(curve_of(hit));
        plot.curves.back().first_counts = hit.counts == CountingRoot::t1;
        plot.curves.back().second_counts = hit.counts != CountingRoot::t1;
    }
    for (const SphereOnLine& passed : explanation.passed) plot.curves.push_back(curve_of(passed));
    std::erase_if(plot.curves, [](const QuadraticCurve& curve) { return !is_finite(curve); });
    if (plot.curves.empty()) return plot;
    const auto front = std::ranges::find(plot.curves, subject, &QuadraticCurve::number);
    if (front != plot.curves.end()) std::rotate(plot.curves.begin(), front, front + 1);

    const QuadraticCurve& curve = plot.curves.front();
    double half = std::sqrt(std::fabs(curve.lowest));
    // Of a tangent ray, as much as leads to a picture.
    if (half < 1e-9 * std::fabs(curve.lowest_t) || half == 0.0)
        half = curve.lowest_t == 0.0 ? 1.0 : 0.2 * std::fabs(curve.lowest_t);
    const double reach = 2.3 * half;
    plot.left = curve.lowest_t - reach;
    plot.right = curve.lowest_t + reach;
    // Where the ray begins is worth some room.
    constexpr double most_reaches = 5.0;
    const double margin = 0.25 * reach;
    if (plot.left > -margin && curve.lowest_t < most_reaches * reach) plot.left = -margin;
    if (plot.right < margin && curve.lowest_t > -most_reaches * reach) plot.right = margin;
    plot.shows_origin = plot.left < 0.0 && plot.right > 0.0;
    const double unit = half * half;
    plot.bottom = std::min(curve.lowest, 0.0) - 0.45 * unit;
    plot.top = std::max(curve.lowest, 0.0) + 2.2 * unit;
    return plot;
}

}  // namespace sphereview

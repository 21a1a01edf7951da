// The quadratics a t^2 + b t + c of a ray as curves. All spheres of a ray have the same a, so their curves are one curve, moved:
// the lower its lowest point, the larger the discriminant.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/explain.hpp"

namespace sphereview {

// In units of a: t^2 + (b / a) t + c / a.
struct QuadraticCurve {
    std::int32_t number = 0;
    double lowest_t = 0.0;  // -b / (2 a)
    double lowest = 0.0;    // -discriminant / (4 a^2)
    int sign = 0;           // of the discriminant
    double t1 = 0.0;        // where it is not below 0
    double t2 = 0.0;
    bool first_counts = false;
    bool second_counts = false;

    double at(double t) const { return (t - lowest_t) * (t - lowest_t) + lowest; }
};

struct QuadraticPlot {
    std::vector<QuadraticCurve> curves;  // the subject first
    double left = 0.0;                   // the drawn range of t
    double right = 1.0;
    double bottom = 0.0;  // the drawn range in units of a
    double top = 1.0;
    bool shows_origin = false;  // t = 0 is in the range
};

// `subject`: the sphere whose curve the plot is fitted to, as for section_of(). No curves if the ray hits and passes nothing.
QuadraticPlot plot_of(const PixelExplanation& explanation, std::int32_t subject);

}  // namespace sphereview

#include "base/sine_cosine.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace sphereview {

namespace {

// Taylor's, for |x| <= pi/4: the first term left out is below 1e-19 for the sine, below 1e-17 for the cosine.
double sine_series(double x) {
    const double s = x * x;
    double sum = 1.0 / 355687428096000.0;
    for (const double factorial : {-1307674368000.0, 6227020800.0, -39916800.0, 362880.0, -5040.0, 120.0, -6.0}) {
        sum = sum * s + 1.0 / factorial;
    }
    return x + x * (s * sum);
}

double cosine_series(double x) {
    const double s = x * x;
    double sum = 1.0 / 20922789888000.0;
    for (const double factorial : {-87178291200.0, 479001600.0, -3628800.0, 40320.0, -720.0, 24.0}) {
        sum = sum * s + 1.0 / factorial;
    }
    return 1.0 + (-0.5 * s + s * (s * sum));
}

}  // namespace

SineCosine sine_cosine(double degrees) {
    // Exact: fmod is, and so is a difference from a near multiple of 90.
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = std::round(turn / 90.0);
    const double x = (turn - 90.0 * quarters) * (std::numbers::pi / 180.0);
    const double sine = sine_series(x);
    const double cosine = cosine_series(x);
    switch ((static_cast<int>(quarters) + 4) % 4) {
        case 0: return {sine, cosine};
        case 1: return {cosine, -sine};
        case 2: return {-sine, -cosine};
        default: return {-cosine, sine};
    }
}

}  // namespace sphereview

#include "base/logarithm.hpp"

#include <cmath>
#include <numbers>

namespace sphereview {

double binary_logarithm(double x) {
    // x = m 2^e with m from sqrt(1/2) to sqrt(2), without rounding.
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0.5 * std::numbers::sqrt2) {
        m *= 2.0;
        --exponent;
    }
    // ln m = 2 artanh s. |s| < 0.1716: the first term left out is below 1e-18.
    const double s = (m - 1.0) / (m + 1.0);
    const double square = s * s;
    double sum = 0.0;
    for (int odd = 21; odd >= 3; odd -= 2) sum = sum * square + 1.0 / odd;
    return exponent + (2.0 * std::numbers::log2e) * (s + s * (square * sum));
}

}  // namespace sphereview

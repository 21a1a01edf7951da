#include "panels/number_text.hpp"

#include <cmath>

#include "base/number.hpp"

namespace sphereview {

namespace {

int leading_digit(double value) {
    return value == 0.0 || !std::isfinite(value) ? 0 : static_cast<int>(std::floor(std::log10(std::fabs(value))));
}

}  // namespace

double rounded_to(double value, int exponent) {
    if (value == 0.0 || !std::isfinite(value)) return value;
    const int digits = leading_digit(value) - exponent;  // behind the first
    if (digits > 16) return value;
    if (digits < 0) {
        const double unit = std::pow(10.0, exponent);
        return std::fabs(value) < 0.5 * unit ? 0.0 : std::copysign(unit, value);
    }
    // Through text, which rounds in decimal: no power of ten is inexact there.
    double rounded = value;
    parse_double(decimal(value, std::chars_format::scientific, digits), rounded);
    return rounded;
}

int last_digit(double value, int digits) { return leading_digit(value) - digits + 1; }

std::string rounded_text(double value, int exponent) {
    if (exponent <= 0 && exponent >= -9 && std::fabs(value) < 1e9) return fixed(value, -exponent);
    return shortest(rounded_to(value, exponent));
}

std::string short_text(double value, int digits) { return decimal(value + 0.0, std::chars_format::general, digits); }

}  // namespace sphereview

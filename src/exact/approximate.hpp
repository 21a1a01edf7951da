// Numbers of 106 bits, each the unevaluated sum of two doubles ("double-double") with a bound on its distance from the exact value.
// The theorems for + and * are in Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building blocks of
// double-word arithmetic", 2017; quotients and roots are checked by multiplying back. docs/exactness.md.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

#include "base/square_root.hpp"

namespace sphereview {

#ifdef __FAST_MATH__
#error "Sums of two doubles need the order of operations that is written."
#endif
static_assert(FLT_EVAL_METHOD == 0, "sums of two doubles need operations that round to double");

// A rounded product: keeps the compiler from fusing the multiplication with what follows, where flags would let it.
inline double rounded_product(double a, double b) {
    double product = a * b;
#if defined(__GNUC__) && defined(__x86_64__)
    asm("" : "+x"(product));
#elif defined(__GNUC__)
    asm("" : "+m"(product));
#endif
    return product;
}

// Two doubles whose sum is exact: `high` is the sum rounded.
struct TwoDoubles {
    double high;
    double low;
};

// Knuth's: a + b exactly, unless it overflows.
inline TwoDoubles two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// The same where a = 0 or |a| >= |b|.
inline TwoDoubles fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

// Two halves of 26 bits or less each, by Dekker; |a| < 2^996.
inline TwoDoubles halves(double a) {
    const double c = rounded_product(0x1p27 + 1.0, a);
    const double high = c - (c - a);
    return {high, a - high};
}

// Dekker's: a b exactly, when 2^-960 < |a b| < 2^1000 or a b = 0.
inline TwoDoubles two_product(double a, double b) {
    const double product = rounded_product(a, b);
    const TwoDoubles x = halves(a);
    const TwoDoubles y = halves(b);
    return {product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

// The exact value is within `error` of high + low, where |low| is at most half a unit in the last place of `high`. An infinite or
// NaN error: nothing is known. Up to sizes of 2^960 `error` covers every overflow and underflow.
struct Approximate {
    double high = 0.0;
    double low = 0.0;
    double error = 0.0;

    static constexpr double unit = 0x1p-103;         // + and * err by less, relative to their results
    static constexpr double margin = 1.0 + 0x1p-48;  // for the roundings of an error's own sum
    static constexpr double least_exact = 0x1p-900;  // smaller products may underflow: they keep no low part
    static constexpr double underflow = 0x1p-950;    // bound on such a low part

    constexpr Approximate() = default;
    constexpr Approximate(double value) : high(value) {}
    constexpr Approximate(TwoDoubles sum, double error_bound) : high(sum.high), low(sum.low), error(error_bound) {}

    bool is_zero() const { return high == 0.0 && error == 0.0; }
    bool is_a_double() const { return low == 0.0; }

    // An upper bound on the size of the exact value.
    double most() const { return (std::fabs(high) + error) * margin; }

    // The sign of the exact value, if that is certain.
    std::optional<int> sign() const {
        if (is_zero()) return 0;
        if (!(std::fabs(high) > error * margin && std::isfinite(high))) return std::nullopt;
        return high > 0.0 ? 1 : -1;
    }

    Approximate operator-() const { return {{-high, -low}, error}; }
    Approximate twice() const { return {{2.0 * high, 2.0 * low}, 2.0 * error}; }
};

inline Approximate operator+(const Approximate& a, const Approximate& b) {
    const TwoDoubles high = two_sum(a.high, b.high);
    if (a.is_a_double() && b.is_a_double()) return {high, (a.error + b.error) * Approximate::margin};
    const TwoDoubles low = two_sum(a.low, b.low);
    const TwoDoubles sum = fast_two_sum(high.high, high.low + low.high);
    const TwoDoubles result = fast_two_sum(sum.high, low.low + sum.low);
    return {result, (a.error + b.error + Approximate::unit * std::fabs(result.high)) * Approximate::margin};
}

inline Approximate operator-(const Approximate& a, const Approximate& b) { return a + -b; }

inline Approximate operator*(const Approximate& a, const Approximate& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const TwoDoubles high = two_product(a.high, b.high);
    const double size = std::fabs(high.high);
    double error = std::fabs(a.high) * b.error + (std::fabs(b.high) + b.error) * a.error;
    if (size < Approximate::least_exact) return {{high.high, 0.0}, (error + Approximate::underflow) * Approximate::margin};
    if ((a.error > 0.0 || b.error > 0.0) && error < Approximate::least_exact)
        error += Approximate::underflow;  // its products may underflow
    if (a.is_a_double() && b.is_a_double()) return {high, error * Approximate::margin};
    const TwoDoubles result = fast_two_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
    return {result, (error + Approximate::unit * size) * Approximate::margin};
}

// A quotient and its correction; the rest a - q b gives the error.
inline Approximate operator/(const Approximate& a, const Approximate& b) {
    const double first = a.high / b.high;
    const double second = (a - Approximate(first) * b).high / b.high;
    Approximate quotient(two_sum(first, second), 0.0);
    const double smallest = std::fabs(b.high) / Approximate::margin - b.error;
    quotient.error =
        smallest > 0.0 ? (a - quotient * b).most() / smallest * Approximate::margin : std::numeric_limits<double>::infinity();
    return quotient;
}

// For exact values of at least 0. |sqrt(a) - s| = |a - s^2| / (sqrt(a) + s), which is at most |a - s^2| / s and sqrt(|a - s^2|).
inline Approximate sqrt(const Approximate& a) {
    const double first = a.high > 0.0 ? square_root(a.high) : 0.0;
    const double second = first > 0.0 ? (a - Approximate(first) * Approximate(first)).high / (2.0 * first) : 0.0;
    Approximate root(two_sum(first, second), 0.0);
    const double rest = (a - root * root).most();
    root.error = square_root(rest) * Approximate::margin;
    if (root.high > 0.0) root.error = std::min(root.error, rest / root.high * Approximate::margin);
    return root;
}

}  // namespace sphereview

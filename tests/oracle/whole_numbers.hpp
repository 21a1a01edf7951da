// Doubles as whole multiples of a power of two.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

namespace sphereview::oracle {

using Unlimited = boost::multiprecision::cpp_int;

// Without allocations, so much faster; throws on overflow rather than being wrong.
using Limited =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                                                         boost::multiprecision::checked, void>>;
inline constexpr int limited_bits = 1024;

// mantissa * 2^exponent; the mantissa is odd, or 0.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

// By the fields of IEEE 754 double precision.
inline Dyadic dyadic(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    std::uint64_t fraction = bits & 0xfffffffffffffULL;
    int exponent = static_cast<int>(bits >> 52 & 0x7ffU);
    if (exponent == 0) {
        exponent = 1;
    } else {
        fraction |= 1ULL << 52;
    }
    if (fraction == 0) return {};
    const int zeros = std::countr_zero(fraction);
    const auto mantissa = static_cast<std::int64_t>(fraction >> zeros);
    return {bits >> 63 != 0 ? -mantissa : mantissa, exponent - 1075 + zeros};
}

// The coarsest grid of spacing 2^k that holds all doubles shown to it.
class Grid {
public:
    void include(double value) {
        const Dyadic parts = dyadic(value);
        if (parts.mantissa == 0) return;
        const auto magnitude = static_cast<std::uint64_t>(parts.mantissa < 0 ? -parts.mantissa : parts.mantissa);
        lowest_ = std::min(lowest_, parts.exponent);
        highest_ = std::max(highest_, parts.exponent + static_cast<int>(std::bit_width(magnitude)));
    }
    void include(const glm::dvec3& v) {
        include(v.x);
        include(v.y);
        include(v.z);
    }

    // The numbers on it are below 2^bits() steps.
    int bits() const { return std::max(0, highest_ - lowest_); }

    // In steps.
    template <typename Integer>
    Integer steps(double value) const {
        const Dyadic parts = dyadic(value);
        Integer whole = 0;
        if (parts.mantissa == 0) return whole;
        whole = 1;
        whole <<= static_cast<unsigned>(parts.exponent - lowest_);
        whole *= parts.mantissa;
        return whole;
    }

private:
    int lowest_ = std::numeric_limits<int>::max() / 2;
    int highest_ = std::numeric_limits<int>::min() / 2;
};

template <typename Integer>
struct WholeVector {
    Integer x;
    Integer y;
    Integer z;

    WholeVector(const Integer& new_x, const Integer& new_y, const Integer& new_z) : x(new_x), y(new_y), z(new_z) {}
    WholeVector(const Grid& grid, const glm::dvec3& v)
        : x(grid.steps<Integer>(v.x)), y(grid.steps<Integer>(v.y)), z(grid.steps<Integer>(v.z)) {}

    friend WholeVector operator-(const WholeVector& a, const WholeVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Integer dot(const WholeVector& a, const WholeVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

}  // namespace sphereview::oracle

// A number whose every operation errs by as much as docs/exactness.md assumes of a GPU, in a direction that the test chooses.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "exact/filter.hpp"

namespace sphereview {

// The directions of the errors of one evaluation, operation by operation: -1, 0 or 1 times the largest error assumed. And
// the differences of what the evaluation compared, so that a search can tell how far a decision was from the other one.
class Rounding {
public:
    static constexpr std::size_t capacity = 128;
    using Directions = std::array<std::int8_t, capacity>;

    explicit Rounding(const Directions& directions) : directions_(directions) { current_ = this; }
    ~Rounding() { current_ = nullptr; }
    Rounding(const Rounding&) = delete;
    Rounding& operator=(const Rounding&) = delete;

    static Rounding& current() { return *current_; }

    // The factor 1 + e of the next operation, |e| at most `units` times the unit.
    double factor(double units) { return 1.0 + directions_.at(operations_++) * units * gpu_unit; }
    std::size_t operations() const { return operations_; }

    void note_less(double difference) { last_less_ = difference; }
    void note_greater(double difference) { greater_.at(greaters_++) = difference; }

    // a - b of the last a < b, and of an a > b counted from the last, 1, or from the first, 0, if there were so many.
    double last_less() const { return last_less_; }
    double greater_from_last(std::size_t count) const { return greater_.at(greaters_ - count); }
    double greater_from_first(std::size_t index) const { return greater_.at(index); }
    std::size_t greaters() const { return greaters_; }

private:
    static inline thread_local Rounding* current_ = nullptr;
    const Directions& directions_;
    std::size_t operations_ = 0;
    double last_less_ = 0.0;
    std::array<double, 8> greater_{};
    std::size_t greaters_ = 0;
};

// Computed in double, whose own error is 2^-32 units.
class Perturbed {
public:
    constexpr Perturbed() = default;
    constexpr explicit Perturbed(double exact) : value_(exact) {}
    // What is uploaded, and whole numbers turned into floats: off by a unit.
    static Perturbed input(double value) { return rounded(value, 1.0); }

    constexpr double value() const { return value_; }

    friend Perturbed operator+(Perturbed a, Perturbed b) { return rounded(a.value_ + b.value_, 1.0); }
    friend Perturbed operator-(Perturbed a, Perturbed b) { return rounded(a.value_ - b.value_, 1.0); }
    friend Perturbed operator*(Perturbed a, Perturbed b) { return rounded(a.value_ * b.value_, 1.0); }
    friend Perturbed operator-(Perturbed a) { return Perturbed(-a.value_); }
    friend Perturbed abs(Perturbed a) { return Perturbed(std::fabs(a.value_)); }
    friend Perturbed square_root(Perturbed a) { return rounded(std::sqrt(a.value_), 2.0); }
    friend Perturbed inverse_sqrt(Perturbed a) { return rounded(1.0 / std::sqrt(a.value_), 2.0); }
    friend bool operator<(Perturbed a, Perturbed b) {
        Rounding::current().note_less(a.value_ - b.value_);
        return a.value_ < b.value_;
    }
    friend bool operator<=(Perturbed a, Perturbed b) { return a.value_ <= b.value_; }
    friend bool operator>(Perturbed a, Perturbed b) {
        Rounding::current().note_greater(a.value_ - b.value_);
        return a.value_ > b.value_;
    }

private:
    static Perturbed rounded(double exact, double units) { return Perturbed(exact * Rounding::current().factor(units)); }

    double value_ = 0.0;
};

}  // namespace sphereview

template <>
struct std::numeric_limits<sphereview::Perturbed> {
    static constexpr bool is_specialized = true;
    static constexpr sphereview::Perturbed infinity() { return sphereview::Perturbed(std::numeric_limits<double>::infinity()); }
};

// exact/approximate.hpp: the exact value always lies within the bound, and the bound is not far too wide.
#include "exact/approximate.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <iostream>

#include "proof/trial.hpp"

namespace sphereview {

namespace {

// Sums and products of the operands below are exact in it.
using Unrounded = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<2600, boost::multiprecision::digit_base_2>>;

double random_double(Random& random, int largest_exponent) {
    const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * largest_exponent + 1)) - largest_exponent;
    const double value = std::ldexp(0.5 + 0.5 * random_unit(random), exponent);
    return random() % 2 == 0 ? value : -value;
}

// Some of one double, some exact, some that differ from `other` by little.
Approximate random_operand(Random& random, int largest_exponent, const Approximate* other) {
    Approximate a;
    a.high = random_double(random, largest_exponent);
    if (other != nullptr && random() % 3 == 0) {
        a.high = (random() % 2 == 0 ? 1.0 : -1.0) * other->high * (1.0 + 0x1p-52 * static_cast<double>(random() % 5));
    }
    if (random() % 4 != 0) {
        const TwoDoubles sum = two_sum(
            a.high, a.high * 0x1p-53 * (2.0 * random_unit(random) - 1.0) * std::ldexp(1.0, -static_cast<int>(random() % 60)));
        a = Approximate(sum, 0.0);
    }
    if (other != nullptr && random() % 8 == 0) a = random() % 2 == 0 ? *other : -*other;
    a.error = random() % 2 == 0 ? 0.0 : std::fabs(a.high) * std::ldexp(1.0, -40 - static_cast<int>(random() % 80));
    if (random() % 50 == 0) a = Approximate(0.0);
    return a;
}

Unrounded unrounded(const Approximate& a) { return Unrounded(a.high) + Unrounded(a.low); }

// A value that `a` may stand for.
Unrounded possible_value(const Approximate& a, Random& random) {
    const int end = static_cast<int>(random() % 3) - 1;
    return unrounded(a) + Unrounded(a.error) * (random() % 2 == 0 ? Unrounded(end) : Unrounded(2.0 * random_unit(random) - 1.0));
}

struct Widest {
    double part = 0.0;  // of the bound that was needed where the operands were exact
};

void expect_within(const Unrounded& value, const Approximate& a, bool exact_operands, Widest& widest, const char* what) {
    const Unrounded off = abs(value - unrounded(a));
    ASSERT_LE(off, Unrounded(a.error)) << what;
    ASSERT_LE(std::fabs(a.low), 0x1p-53 * std::fabs(a.high)) << what;
    ASSERT_EQ(a.sign().value_or(value.sign()), value.sign()) << what;
    if (exact_operands && a.error > 0.0) widest.part = std::max(widest.part, static_cast<double>(Unrounded(off / a.error)));
}

TEST(Approximate, holds_the_exact_value) {
    Random random(test_seed());
    Widest sums;
    Widest products;
    Widest quotients;
    Widest roots;
    const int count = trial_count(15'000);
    for (int i = 0; i < count; ++i) {
        const int largest_exponent = i % 2 == 0 ? 3 : 400;
        const Approximate a = random_operand(random, largest_exponent, nullptr);
        const Approximate b = random_operand(random, largest_exponent, &a);
        const Unrounded x = possible_value(a, random);
        const Unrounded y = possible_value(b, random);
        const bool exact = a.error == 0.0 && b.error == 0.0;
        expect_within(x + y, a + b, exact, sums, "sum");
        expect_within(x - y, a - b, exact, sums, "difference");
        expect_within(x * y, a * b, exact, products, "product");
        if (y != 0 && std::isfinite((a / b).error)) expect_within(x / y, a / b, exact, quotients, "quotient");
        if (x >= 0) expect_within(sqrt(x), sqrt(a), exact, roots, "square root");
    }
    std::cout << "the part of the bound that was needed: sums " << sums.part << ", products " << products.part << ", quotients "
              << quotients.part << ", square roots " << roots.part << '\n';
    for (const double part : {sums.part, products.part, quotients.part, roots.part}) EXPECT_GT(part, 1.0 / 64.0);
}

TEST(Approximate, knows_products_that_underflow) {
    Random random(test_seed());
    Widest unused;
    for (int i = 0; i < trial_count(20'000); ++i) {
        Approximate a = random_operand(random, 530, nullptr);
        const Approximate b = random_operand(random, 500, &a);
        if (std::fabs(a.high * b.high) > 0x1p900) continue;
        // Of what was too small for a scale: its product with the other number underflows, and must count all the same.
        if (i % 2 == 0) a.error = std::ldexp(1.0, -900 - static_cast<int>(random() % 174));
        expect_within(possible_value(a, random) * possible_value(b, random), a * b, false, unused, "product");
    }
}

TEST(Approximate, is_narrow_and_exact_where_it_can_be) {
    const Approximate third = Approximate(1.0) / Approximate(3.0);
    EXPECT_LT(third.error, 0x1p-100);
    EXPECT_LT((third * third - third / Approximate(3.0)).most(), 0x1p-100);
    EXPECT_LT(sqrt(Approximate(2.0)).error, 0x1p-99);
    EXPECT_EQ((Approximate(0.1) * Approximate(0.3)).error, 0.0);
    EXPECT_EQ((Approximate(0.1) + Approximate(1e15)).error, 0.0);
    EXPECT_EQ((Approximate(0.1) * Approximate(0.3) - Approximate(0.1) * Approximate(0.3)).sign(), 0);
    EXPECT_EQ((Approximate(1.0) / Approximate(0.0)).sign(), std::nullopt);
    EXPECT_EQ((Approximate(0x1p600) * Approximate(0x1p600)).sign(), std::nullopt);
}

}  // namespace

}  // namespace sphereview

#include "base/square_root.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace sphereview {
namespace {

__extension__ using Wide = unsigned __int128;

// Whether no double is nearer to the root of x: in whole numbers, with the root as R * 2^k of 53 bits and x as M * 4^k, R is at
// most half from the root of M. `x` is normal.
bool is_nearest(double x, double root) {
    const int k = std::ilogb(root) - 52;
    const auto whole_root = static_cast<Wide>(std::scalbn(root, -k));
    const int twice = -2 * k;  // of x's power of two; the parts keep within the range of doubles
    const int down = std::ilogb(x) - 52;
    const Wide m = static_cast<Wide>(std::scalbn(x, -down)) << (down + twice);
    return (2 * whole_root - 1) * (2 * whole_root - 1) < 4 * m && 4 * m < (2 * whole_root + 1) * (2 * whole_root + 1);
}

TEST(SquareRoot, IsRoundedOnce) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 1'000'000; ++i) {
        const double x = std::scalbn(static_cast<double>(random() >> 11 | 1ULL << 52), static_cast<int>(random() % 1900) - 1000);
        ASSERT_TRUE(is_nearest(x, square_root(x))) << std::hexfloat << x;
    }
    // Just above and below the middle between two doubles: where rounding to 64 bits first goes wrong.
    for (std::uint64_t root = (1ULL << 53) - 200'000; root < 1ULL << 53; ++root) {
        const Wide square = Wide{root} * root + root;  // (root + 1/2)^2, less 1/4
        const double x = static_cast<double>(square);
        ASSERT_TRUE(is_nearest(x, square_root(x))) << std::hexfloat << x;
        ASSERT_TRUE(is_nearest(std::nextafter(x, 1e300), square_root(std::nextafter(x, 1e300)))) << std::hexfloat << x;
    }
}

TEST(SquareRoot, OfFloatsIsTheRoundedOneOfDoubles) {
    std::mt19937 random(2);
    for (int i = 0; i < 1'000'000; ++i) {
        const float x = std::scalbn(static_cast<float>(random() >> 8 | 1U << 23), static_cast<int>(random() % 200) - 100);
        ASSERT_EQ(square_root(x), static_cast<float>(square_root(static_cast<double>(x)))) << std::hexfloat << x;
    }
}

TEST(SquareRoot, OfTheEndsOfTheRange) {
    EXPECT_EQ(square_root(0.0), 0.0);
    EXPECT_EQ(square_root(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
    EXPECT_EQ(square_root(0x1p-1074), 0x1p-537);
    EXPECT_EQ(square_root(0x1p1022), 0x1p511);
}

}  // namespace
}  // namespace sphereview

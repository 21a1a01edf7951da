// The oracle itself, against roots that are known.
#include "oracle/roots.hpp"

#include <gtest/gtest.h>

#include "oracle/oracle.hpp"
#include "oracle/random.hpp"
#include "oracle/scenes.hpp"
#include "oracle/whole_numbers.hpp"
#include "support/spheres.hpp"

namespace sphereview::oracle {

namespace {

constexpr long long a = 6;

// a (t - first) (t - second)
Quadratic<Unlimited> with_roots(long long first, long long second) { return {a / 2 * (first + second), a * first * second}; }

int sign(long long value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

TEST(Roots, whole_ones_are_ordered) {
    constexpr int most = 4;
    for (int p1 = -most; p1 <= most; ++p1) {
        for (int p2 = p1; p2 <= most; ++p2) {
            const auto p = with_roots(p1, p2);
            for (int q1 = -most; q1 <= most; ++q1) {
                ASSERT_EQ(root_against<Unlimited>(a, p, Which::smaller, q1 * 5, 5), sign(p1 - q1));
                ASSERT_EQ(root_against<Unlimited>(a, p, Which::larger, q1 * 5, 5), sign(p2 - q1));
                for (int q2 = q1; q2 <= most; ++q2) {
                    const auto q = with_roots(q1, q2);
                    const std::string what =
                        std::to_string(p1) + " " + std::to_string(p2) + ", " + std::to_string(q1) + " " + std::to_string(q2);
                    ASSERT_EQ(compare_roots<Unlimited>(a, p, Which::smaller, q, Which::smaller), sign(p1 - q1)) << what;
                    ASSERT_EQ(compare_roots<Unlimited>(a, p, Which::smaller, q, Which::larger), sign(p1 - q2)) << what;
                    ASSERT_EQ(compare_roots<Unlimited>(a, p, Which::larger, q, Which::smaller), sign(p2 - q1)) << what;
                    ASSERT_EQ(compare_roots<Unlimited>(a, p, Which::larger, q, Which::larger), sign(p2 - q2)) << what;
                }
            }
        }
    }
}

TEST(Roots, irrational_ones_are_ordered) {
    // With a = 1: b -+ sqrt(b^2 - c); of size 1 to 1000, so in long double as good as exact unless equal.
    Random random(seed());
    for (int i = 0; i < 20000; ++i) {
        const auto any = [&](Quadratic<Unlimited>& p, long double& smaller, long double& larger) {
            const int b = random.whole(-30, 30);
            const int d = random.whole(0, 900);
            p = {b, Unlimited(b) * b - d};
            smaller = static_cast<long double>(b) - std::sqrt(static_cast<long double>(d));
            larger = static_cast<long double>(b) + std::sqrt(static_cast<long double>(d));
        };
        Quadratic<Unlimited> p;
        Quadratic<Unlimited> q;
        long double p1 = 0;
        long double p2 = 0;
        long double q1 = 0;
        long double q2 = 0;
        any(p, p1, p2);
        any(q, q1, q2);
        // Different ones of this size are further apart: their difference has a polynomial with whole coefficients.
        const auto order = [](long double x, long double y) { return std::fabs(x - y) < 1e-12L ? 0 : x < y ? -1 : 1; };
        ASSERT_EQ(compare_roots<Unlimited>(1, p, Which::smaller, q, Which::smaller), order(p1, q1));
        ASSERT_EQ(compare_roots<Unlimited>(1, p, Which::smaller, q, Which::larger), order(p1, q2));
        ASSERT_EQ(compare_roots<Unlimited>(1, p, Which::larger, q, Which::smaller), order(p2, q1));
        ASSERT_EQ(compare_roots<Unlimited>(1, p, Which::larger, q, Which::larger), order(p2, q2));
    }
}

TEST(WholeNumbers, doubles_are_taken_apart_and_put_together) {
    Random random(seed());
    for (int i = 0; i < 20000; ++i) {
        const auto value = std::bit_cast<double>(random.bits());
        if (!std::isfinite(value)) continue;
        const Dyadic parts = dyadic(value);
        ASSERT_EQ(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent), value);
        Grid grid;
        grid.include(value);
        grid.include(1.0);
        ASSERT_EQ(sign(grid.steps<Unlimited>(value) > 0 ? 1 : -1), value > 0 ? 1 : -1);
        ASSERT_LE(msb(abs(grid.steps<Unlimited>(value))), static_cast<unsigned>(grid.bits()));
    }
    EXPECT_EQ(dyadic(-0.0).mantissa, 0);
    EXPECT_EQ(dyadic(0x1p-1074).exponent, -1074);
    EXPECT_EQ(dyadic(-40.0).mantissa, -5);
}

// By hand: the default camera, 3 x 3 pixels, rays (2i / 3 - 2 / 3, ..., 2) times 50.
TEST(Oracle, pictures_that_are_known) {
    Scene scene = scene_of({{{0, 0, 200}, 20}});
    EXPECT_EQ(picture(scene, {3, 3}), (std::vector<std::int32_t>{-1, -1, -1, -1, 0, -1, -1, -1, -1}));
    scene.spheres.push_back({{0, 0, 200}, 20});  // a copy
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{0}));
    scene.spheres.insert(scene.spheres.begin(), {{50, 0, 50}, 50});  // touches the axis at 50
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{0}));
    scene.spheres[0].radius = std::nextafter(50.0, 0.0);
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{1}));
    scene.spheres[1].hidden = true;
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{2}));
    scene.spheres.push_back({{0, 0, 60}, 60});  // the eye is on its surface; seen at 120
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{3}));
    scene.spheres.push_back({{0, 0, -60}, 60});  // the same behind: its roots are 0 and -120
    scene.spheres.push_back({{0, 0, 10}, 100});  // the eye is inside; seen at 110
    EXPECT_EQ(picture(scene, {1, 1}), (std::vector<std::int32_t>{5}));
    EXPECT_EQ(oracle::eye_side(scene.spheres[3], scene.camera.eye), 0);
    EXPECT_EQ(oracle::eye_side(scene.spheres[5], scene.camera.eye), -1);
    EXPECT_EQ(oracle::eye_side(scene.spheres[0], scene.camera.eye), 1);
    // A wide picture shows more to the sides: pixel (4, 0) of 5 x 1 looks along (200, 0, 100).
    scene.spheres = {{{200, 0, 100}, 1}};
    EXPECT_EQ(picture(scene, {5, 1}), (std::vector<std::int32_t>{-1, -1, -1, -1, 0}));
    scene.spheres = {{{0, 200, 100}, 1}};
    EXPECT_EQ(picture(scene, {1, 5}), (std::vector<std::int32_t>{0, -1, -1, -1, -1}));
}

}  // namespace

}  // namespace sphereview::oracle

// Whether a light shines: 106 bits claim nothing that integers deny, of points and of balls around them.
#include "exact/approximate_light.hpp"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <iostream>

#include "exact/exact_light.hpp"
#include "proof/trial.hpp"
#include "proof/truth.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// Whole numbers as the sky's lights have, or any doubles; every third is nearly at a right angle to the normal.
glm::dvec3 direction_for(const glm::dvec3& normal, Random& random) {
    glm::dvec3 direction = in_cube(random);
    if (random() % 3 == 0) direction = cross(normal, direction) + std::exp2(-100.0 * random_unit(random)) * in_cube(random);
    if (random() % 2 == 0) direction = glm::round(1000.0 * direction);
    return direction == glm::dvec3(0.0) ? glm::dvec3(1.0, 0.0, 0.0) : direction;
}

// The line from a point to the light nearly touches it, or it nearly touches the point, or neither.
Sphere sphere_beside(const glm::dvec3& point, const glm::dvec3& direction, const Sphere& own, Random& random) {
    const double size = own.radius * std::exp2(between(random, -20.0, 40.0));
    const double nearly = 1.0 + (random() % 2 == 0 ? 1.0 : -1.0) * std::exp2(between(random, -60.0, 0.0));
    const glm::dvec3 toward = unit(direction);
    const glm::dvec3 aside = unit(cross(toward, in_cube(random)));
    switch (random() % 4) {
        case 0: return {point + size * unit(in_cube(random)), std::max(size * nearly, 1e-300)};
        case 1: return {point + size * in_cube(random), size};
        default: return {point + size * between(random, -0.1, 2.0) * toward + size * nearly * aside, size};
    }
}

struct Count {
    int all = 0;
    int unsure = 0;
};

// Compares two answers, of which one may be missing.
template <typename Answer>
void compare(Count& count, const std::optional<Answer>& found, const Answer& expected, const Trial& trial, const char* what) {
    ++count.all;
    if (found) {
        ASSERT_EQ(*found, expected) << what << '\n' << to_string(trial);
    } else {
        ++count.unsure;
    }
}

std::optional<bool> sure(Shadow shadow) { return shadow == Shadow::unsure ? std::nullopt : std::optional(shadow == Shadow::all); }

void expect_what_integers_say(bool parallel, int trials) {
    Random random(test_seed());
    Count facing;
    Count shadows;
    Count balls;
    int dark = 0;
    for (int i = 0; i < trials; ++i) {
        Trial trial = random_trial(random, i % 2 == 0 ? double_unit : 0x1p-100);
        if (parallel) trial = with_parallel_rays(trial);
        const Truth truth = true_hit(trial);
        if (camera_fault(trial.camera) || !truth.hit) continue;
        const EyeSide side = EyeSides(trial.camera)(trial.sphere);
        const ExactBasis basis(trial.camera);
        const ApproximateLitPoint point(trial.camera, basis, trial.size, trial.pixel, trial.sphere, side);
        const ExactLitPoint exact(trial.camera, trial.size, trial.pixel, trial.sphere, side);
        const glm::dvec3 place = trial.camera.eye + truth.point;
        const glm::dvec3 direction = direction_for(place - trial.sphere.center, random);
        compare(facing, point.facing(direction), exact.facing(direction), trial, "facing");
        const Sphere other = sphere_beside(place, direction, trial.sphere, random);
        const bool blocked = exact.blocking(other, direction).blocks();
        compare(shadows, sure(point.shadow(other, direction)), blocked, trial, "shadow");
        dark += blocked ? 1 : 0;
        // The point lies in the ball, often near its edge. What it is said to be is rounded.
        const double error = length_of(truth.point) * std::exp2(between(random, -48.0, -4.0));
        const glm::dvec3 off = 0.99 * error * unit(random() % 2 == 0 ? direction : in_cube(random));
        const PointBall ball{0x1p-20 * (truth.point + off), 0x1p-20 * error, -20};
        compare(balls, sure(approximate_shadow(ball, trial.camera.eye, other, direction)), blocked, trial, "ball");
    }
    std::cout << facing.all << " points, " << dark << " in shadow; 106 bits are unsure of the facing of " << facing.unsure
              << ", of the shadow of " << shadows.unsure << ", of a ball of " << balls.unsure << '\n';
    EXPECT_GT(dark, facing.all / 10);
    EXPECT_LT(facing.unsure, facing.all / 50);
    EXPECT_LT(shadows.unsure, shadows.all / 25);
    EXPECT_LT(balls.unsure, balls.all * 2 / 3);
}

TEST(ApproximateLight, is_that_of_integers) { expect_what_integers_say(false, trial_count(40'000)); }

TEST(ApproximateLight, of_parallel_rays_is_that_of_integers) { expect_what_integers_say(true, trial_count(20'000)); }

// A line that touches a sphere is the integers'.
TEST(ApproximateLight, leaves_tangent_lines_open) {
    const Camera camera{{0.0, 0.0, 0.0}, {0.0, 0.0, 100.0}, {50.0, 0.0, 0.0}, {0.0, 50.0, 0.0}};
    const Sphere sphere{{0.0, 0.0, 7.0}, 2.1, {}, false};
    const ExactBasis basis(camera);
    const ApproximateLitPoint point(camera, basis, {1, 1}, {0, 0}, sphere, EyeSide::outside);
    const glm::dvec3 toward_eye{0.0, 0.0, -3.0};
    EXPECT_EQ(point.facing(toward_eye), 1);
    EXPECT_EQ(point.shadow({{0.0, 0.0, 4.0}, 0.5, {}, false}, toward_eye), Shadow::all);
    EXPECT_EQ(point.shadow({{0.0, 0.0, 4.0}, 0.5, {}, false}, {0.0, 1.0, -1.0}), Shadow::none);
    EXPECT_EQ(point.shadow({{0.5, 0.0, 4.0}, 0.5, {}, false}, toward_eye), Shadow::unsure);
}

}  // namespace

}  // namespace sphereview

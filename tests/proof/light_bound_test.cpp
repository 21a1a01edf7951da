// The bounds of docs/exactness.md, "Light", against arithmetic that errs as much as is assumed, in the worst directions that a
// search finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/vec3.hpp>

#include "light/light_tiles.hpp"
#include "proof/perturbed.hpp"
#include "proof/trial.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// A point, as LitPoints have it, on the very edge of a sphere's disc and as high as its centre: so every claim is wrong.
struct EdgeTrial {
    glm::dvec3 across;
    glm::dvec3 upward;
    glm::dvec3 height;
    glm::dvec3 point;
    glm::dvec3 center;
    double radius;
};

EdgeTrial edge_trial(Random& random) {
    EdgeTrial trial{};
    trial.height = unit(in_cube(random));
    trial.across = unit(cross(trial.height, in_cube(random)));
    trial.upward = cross(trial.height, trial.across);
    trial.point = in_cube(random);
    trial.radius = std::pow(10.0, between(random, -4.0, 4.0));
    const glm::dvec3 aside = in_cube(random);
    trial.center = trial.point + trial.radius * unit(aside.x * trial.across + aside.y * trial.upward);
    return trial;
}

struct Outcome {
    double excess;  // by how much the boldest claim goes beyond what it needs; positive: something wrong is claimed
    std::size_t operations;
};

// What LightTiles computes of a point and a sphere (find_discs(), is_lit()), with `factor` times the bound.
Outcome run(const EdgeTrial& trial, const Rounding::Directions& directions, double factor) {
    Rounding rounding(directions);
    using Vector = std::array<Perturbed, 3>;
    const auto input = [](const glm::dvec3& v) -> Vector {
        return {Perturbed::input(v.x), Perturbed::input(v.y), Perturbed::input(v.z)};
    };
    const auto times = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const Vector across = input(trial.across);
    const Vector upward = input(trial.upward);
    const Vector height = input(trial.height);
    const Vector point = input(trial.point);
    const Vector center = input(trial.center);
    const Perturbed radius = Perturbed::input(trial.radius);
    const Perturbed size = abs(center[0]) + abs(center[1]) + abs(center[2]) + radius;
    const Perturbed scale = Perturbed::input(factor * light_roundings * gpu_unit);
    const Perturbed doubt = scale + scale * size;
    const Perturbed x = times(point, across) - times(center, across);
    const Perturbed y = times(point, upward) - times(center, upward);
    const Perturbed distance = x * x + y * y;
    const Perturbed center_height = times(center, height);
    const Perturbed point_height = times(point, height);
    const Perturbed outer = (radius + doubt) * (radius + doubt);
    const double surely_out = std::sqrt(distance.value()) - std::sqrt(outer.value());
    double surely_in = -1.0;
    if (radius.value() > doubt.value()) {
        const Perturbed inner = (radius - doubt) * (radius - doubt);
        surely_in = std::sqrt(inner.value()) - std::sqrt(distance.value());
    }
    const double higher = (center_height - doubt).value() - point_height.value();
    const double lower = point_height.value() - (center_height + doubt).value();
    return {std::max({surely_out, surely_in, higher, lower}), rounding.operations()};
}

// Reverses errors, one at a time, as long as that makes things worse. Returns the excess.
double worst(const EdgeTrial& trial, Random& random, double factor) {
    Rounding::Directions directions{};
    for (std::int8_t& direction : directions) direction = random() % 2 == 0 ? 1 : -1;
    Outcome most = run(trial, directions, factor);
    for (int pass = 0; pass < 3; ++pass) {
        const double before = most.excess;
        for (std::size_t i = 0; i < most.operations; ++i) {
            directions[i] = static_cast<std::int8_t>(-directions[i]);
            const Outcome outcome = run(trial, directions, factor);
            if (outcome.excess > most.excess) {
                most = outcome;
            } else {
                directions[i] = static_cast<std::int8_t>(-directions[i]);
            }
        }
        if (most.excess <= before) break;
    }
    return most.excess;
}

int broken(int trials, double factor) {
    Random random(test_seed());
    int count = 0;
    for (int i = 0; i < trials; ++i) {
        const EdgeTrial trial = edge_trial(random);
        if (worst(trial, random, factor) > 0.0) ++count;
    }
    return count;
}

TEST(LightBound, no_claim_about_a_disc_is_broken) { EXPECT_EQ(broken(trial_count(10000), 1.0), 0); }

TEST(LightBound, an_eighth_of_the_bound_of_a_disc_is_too_little) { EXPECT_GT(broken(trial_count(10000), 0.125), 0); }

// The largest error of a product of normal and direction in float, with normals as LitPoints keep them.
double largest_error_of_facing(int trials) {
    Random random(test_seed());
    double largest = 0.0;
    for (int i = 0; i < trials; ++i) {
        const glm::dvec3 direction = unit(in_cube(random));
        const glm::dvec3 normal = unit(in_cube(random));
        float facing = 0.0F;
        for (int axis = 0; axis < 3; ++axis) {
            // Off by as much as a point may be of which LitPoints know.
            const double off = normal[axis] + (random() % 2 == 0 ? most_normal_error : -most_normal_error);
            const std::int16_t whole = whole_normal(off);
            facing += static_cast<float>(whole) * (static_cast<float>(direction[axis]) / LitPoints::normal_unit);
        }
        largest = std::max(largest, std::fabs(static_cast<double>(facing) - dot(normal, direction)));
    }
    return largest;
}

TEST(LightBound, facing_is_within_its_bound_and_not_within_three_quarters) {
    const double largest = largest_error_of_facing(trial_count(1'000'000));
    const auto bound = static_cast<double>(LightTileLimits{}.facing_doubt);
    std::printf("the largest error of facing: %.3f of the bound\n", largest / bound);
    EXPECT_LT(largest, bound);
    EXPECT_GT(largest, 0.75 * bound);
}

}  // namespace

}  // namespace sphereview

// Where rays hit spheres, and how far that is from other spheres along a light and across it: double is off by less than it says.
#include "light/hit_places.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>

#include "proof/trial.hpp"
#include "proof/truth.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

// A 2,000th of a double's own rounding.
using Long = long double;
using LongVector = std::array<Long, 3>;

LongVector to_long(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Long product(const LongVector& a, const LongVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double distance_between(const glm::dvec3& a, const glm::dvec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

struct Largest {
    double distance = 0.0;  // parts of what is claimed
    double place = 0.0;
    int known = 0;
};

// Of places the errors in parts of the bounds, in truth and as they are said.
Largest largest_errors_of_places(bool parallel, int trials) {
    Random random(test_seed());
    Largest largest;
    for (int i = 0; i < trials; ++i) {
        Trial trial = random_trial(random, double_unit);
        if (parallel) trial = with_parallel_rays(trial);
        const Truth truth = true_hit(trial);
        if (camera_fault(trial.camera) || !truth.hit) continue;
        const HitPlaces places(trial.camera, trial.size);
        const HitDistance distance = places.distance(places.ray(trial.pixel), trial.sphere, truth.side);
        if (!std::isfinite(distance.half)) continue;
        const HitPlace place = places.at(places.ray(trial.pixel), distance);
        ++largest.known;
        // A point exactly as far as is said is none that can be off.
        const double off = std::fabs(truth.distance - distance.middle);
        if (off > 0.0) largest.distance = std::max(largest.distance, off / distance.half);
        largest.place = std::max(largest.place, distance_between(truth.point, place.point) / place.error);
        EXPECT_LE(distance_between(truth.point, place.point), place.error) << to_string(trial);
    }
    return largest;
}

void expect_places_within_their_bounds(bool parallel) {
    const int trials = trial_count(20'000);
    const Largest largest = largest_errors_of_places(parallel, trials);
    std::cout << largest.known << " places; the largest errors: " << largest.distance << " of a distance's bound, " << largest.place
              << " of a place's\n";
    EXPECT_GT(largest.known, trials / 10);
    EXPECT_LE(largest.distance, 1.0);
    EXPECT_GT(largest.place, 0.5);
}

TEST(HitPlaces, are_where_the_ray_hits) { expect_places_within_their_bounds(false); }

TEST(HitPlaces, of_parallel_rays_are_where_the_ray_hits) { expect_places_within_their_bounds(true); }

struct Off {
    double along;
    double across;
};

// By how much an offset is off, of a point that is known exactly.
Off errors(const PlaceOffset& offset, const glm::dvec3& point, const glm::dvec3& center, const glm::dvec3& direction) {
    LongVector l = to_long(direction);
    const Long length = std::sqrt(product(l, l));
    for (Long& component : l) component /= length;
    LongVector m = to_long(point);
    const LongVector c = to_long(center);
    for (std::size_t axis = 0; axis < 3; ++axis) m.at(axis) -= c.at(axis);
    const Long along = product(m, l);
    for (std::size_t axis = 0; axis < 3; ++axis) m.at(axis) -= along * l.at(axis);
    return {static_cast<double>(std::fabs(offset.along - along)),
            static_cast<double>(std::fabs(offset.across - std::sqrt(product(m, m))))};
}

// Points beside spheres of any size, near and far; the place is off by as much as it says, in any direction.
TEST(HitPlaces, offsets_from_spheres_are_off_by_less_than_they_say) {
    Random random(test_seed());
    double largest_rounding = 0.0;
    double largest = 0.0;
    const int trials = trial_count(200'000);
    for (int i = 0; i < trials; ++i) {
        const glm::dvec3 direction = std::exp2(40.0 * random_unit(random) - 20.0) * in_cube(random);
        const glm::dvec3 point = std::exp2(20.0 * random_unit(random) - 10.0) * in_cube(random);
        const double radius = std::exp2(30.0 * random_unit(random) - 20.0);
        // Far along the light, or across it, or on the surface.
        const glm::dvec3 away = random() % 3 == 0 ? unit(direction) : unit(in_cube(random));
        const glm::dvec3 center = point + (random() % 2 == 0 ? radius : std::exp2(20.0 * random_unit(random) - 10.0)) * away;

        const PlaceOffset exact = offset_from({point, 0.0}, center, radius, direction);
        const Off rounded = errors(exact, point, center, direction);
        largest_rounding = std::max(largest_rounding, std::max(rounded.along, rounded.across) / exact.doubt);

        const double error = std::exp2(-10.0 - 40.0 * random_unit(random));
        const glm::dvec3 off = point + 0.9999 * error * unit(random() % 2 == 0 ? direction : in_cube(random));
        const PlaceOffset said = offset_from({off, error}, center, radius, direction);
        const Off found = errors(said, point, center, direction);
        largest = std::max(largest, std::max(found.along, found.across) / said.doubt);
    }
    std::cout << "the largest errors: " << largest_rounding << " of the bound by rounding, " << largest
              << " with the place's own\n";
    EXPECT_LT(largest, 1.0);
    EXPECT_GT(largest, 0.9);
    EXPECT_LT(largest_rounding, 1.0);
    EXPECT_GT(largest_rounding, 1.0 / 64.0);
}

}  // namespace

}  // namespace sphereview

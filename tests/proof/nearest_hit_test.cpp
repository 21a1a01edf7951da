// Which of two spheres is hit first: differences in double and in 106 bits claim nothing that integers deny.
#include "exact/nearest_hit.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "exact/pixel_lanes.hpp"
#include "proof/trial.hpp"
#include "scene/vectors.hpp"
#include "support/decide_exactly.hpp"

namespace sphereview {

namespace {

// `value`, off by up to some units in its last place.
double nearly(double value, int units, Random& random) {
    return value * (1.0 + 0x1p-52 * std::floor((2.0 * random_unit(random) - 1.0) * units));
}

// Another sphere that is hard to tell from the trial's: nearly the same, or through nearly the same point of the ray.
Sphere rival_of(const Trial& trial, const glm::dvec3& point, Random& random) {
    Sphere rival = trial.sphere;
    const int units = 1 << random() % 30;
    switch (random() % 6) {
        case 0: rival.radius = nearly(rival.radius, units, random); break;
        case 1:
            rival.center = {nearly(rival.center.x, units, random), rival.center.y, nearly(rival.center.z, units, random)};
            break;
        case 5: rival.center.x = nearly(rival.center.x, units, random); break;
        case 2: {
            const double part = std::exp2(12.0 * random_unit(random) - 6.0);
            rival.center = point + part * (trial.sphere.center - point);
            rival.radius = nearly(part * trial.sphere.radius, units, random);
            break;
        }
        case 3: {
            const double r = trial.sphere.radius * std::exp2(12.0 * random_unit(random) - 6.0);
            const glm::dvec3 to(random_unit(random) - 0.5, random_unit(random) - 0.5, random_unit(random) - 0.5);
            rival.center = point + r * unit(to);
            rival.radius = nearly(r, units, random);
            break;
        }
        default: rival.center += rival.radius * glm::dvec3(random_unit(random), random_unit(random), random_unit(random));
    }
    if (!(rival.radius > 0.0) || !std::isfinite(rival.radius)) rival.radius = 1.0;
    return rival;
}

void expect_the_hit_of_integers(bool parallel, int count) {
    Random random(test_seed());
    int in_double = 0;
    int in_integers = 0;
    int nearer = 0;
    int pairs = 0;
    for (int i = 0; i < count; ++i) {
        Trial trial = random_trial(random, i % 2 == 0 ? double_unit : 0x1p-100);
        if (parallel) trial = with_parallel_rays(trial);
        if (camera_fault(trial.camera)) continue;
        // A number so small beside the others that no scale holds them all.
        if (i % 5 == 0) trial.sphere.center.x = std::ldexp(random_unit(random) - 0.5, -800 - static_cast<int>(random() % 260));
        const auto on_scale = [&](const SphereScale& scale, const Sphere& sphere, int number) {
            return scale(sphere, number, EyeSides(trial.camera)(sphere));
        };
        const ExactBasis basis(trial.camera);
        NearestHit nearest(trial.camera, basis, trial.size, trial.pixel);
        const double power = std::ldexp(1.0, static_cast<int>(random() % 3) * 150);
        const double largest = std::min(power * size_from(trial.camera.eye, trial.sphere), 0x1p1023);
        const SphereScale scale(trial.camera.eye, largest);
        if (!nearest.challenge(on_scale(scale, trial.sphere, 1))) continue;
        glm::dvec3 point = trial.camera.eye;
        const double back =
            trial.sphere.center == point ? 0.0 : largest_of(trial.sphere.center) / largest_of(nearest.sphere()->position);
        for (int axis = 0; axis < 3; ++axis) point[axis] += nearest.point()[static_cast<std::size_t>(axis)].high * back;
        const Sphere rival = rival_of(trial, point, random);
        if (!std::isfinite(largest_of(rival.center))) continue;
        const int number = static_cast<int>(random() % 2) * 2;  // 0 or 2: the trial's is 1

        ++pairs;
        const ScaledSphere challenger = on_scale(scale, rival, number);
        DifferenceLanes lanes(1);
        lanes.set(0, nearest);
        const bool challenged = lanes.challenged_by(challenger) != 0;
        const std::array<Contender, 2> both = {Contender{1, &trial.sphere}, Contender{number, &rival}};
        const std::int32_t first = decide_exactly(trial.camera, trial.size, trial.pixel, both);
        const std::int64_t before = nearest.in_integers();
        nearest.challenge(challenger);
        ASSERT_EQ(nearest.visible(), first) << "trial " << i << '\n' << to_string(trial);
        ASSERT_TRUE(challenged || first == 1) << "trial " << i << '\n' << to_string(trial);
        in_double += challenged ? 0 : 1;
        in_integers += nearest.in_integers() > before ? 1 : 0;
        nearer += first == number ? 1 : 0;
    }
    std::cout << pairs << " pairs: the second is nearer in " << nearer << ", double tells that it is not in " << in_double
              << ", integers are needed for " << in_integers << '\n';
    EXPECT_GT(nearer, pairs / 10);
    EXPECT_GT(in_double, pairs / 4);
    EXPECT_LT(in_integers, pairs / 10);
}

TEST(NearestHit, is_that_of_integers) { expect_the_hit_of_integers(false, trial_count(60'000)); }

TEST(NearestHit, of_parallel_rays_is_that_of_integers) { expect_the_hit_of_integers(true, trial_count(30'000)); }

// Two spheres that nearly touch the eye, each with a number that is too small for their scale. Its square, all that keeps the
// sphere off the eye, is smaller than any double.
TEST(NearestHit, counts_errors_whose_squares_underflow) {
    Camera camera;
    camera.center = {1.0, 0.0, 0.0};
    camera.right = {0.0, 0.0, 1.0};
    const PictureSize size{1, 1};
    const Pixel pixel{0, 0};
    const Sphere farther{.center = {0x1p1000, 0x1p-500, 0.0}, .radius = 0x1p1000};
    const Sphere nearer{.center = {0x1p1000, 0x1p-501, 0.0}, .radius = 0x1p1000};
    const std::array<Contender, 2> both = {Contender{0, &farther}, Contender{1, &nearer}};
    ASSERT_EQ(decide_exactly(camera, size, pixel, both), 1);

    const ExactBasis basis(camera);
    const SphereScale scale(camera.eye, 0x1p1000);
    NearestHit nearest(camera, basis, size, pixel);
    for (const Contender& contender : both) {
        const EyeSide side = eye_side(*contender.sphere, camera.eye);
        ASSERT_EQ(side, EyeSide::outside);
        const ScaledSphere scaled = scale(*contender.sphere, contender.number, side);
        EXPECT_GT(scaled.c.error, 0.0);
        DifferenceLanes lanes(1);
        lanes.set(0, nearest);
        EXPECT_NE(lanes.challenged_by(scaled), 0U);
        nearest.challenge(scaled);
    }
    EXPECT_EQ(nearest.visible(), 1);
}

}  // namespace

}  // namespace sphereview

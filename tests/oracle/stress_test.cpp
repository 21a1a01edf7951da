// Exact work has a bound: thousands of spheres that double cannot tell apart take no more than seconds, and hardly any integers.
#include <gtest/gtest.h>

#include <ctime>
#include <iostream>

#include "cpu/cpu_renderer.hpp"
#include "exact/resolve.hpp"
#include "oracle/oracle.hpp"
#include "oracle/scenes.hpp"

namespace sphereview::oracle {

namespace {

// As when a renderer finds every pixel doubtful.
DecisionCounts certified(const Trial& trial, std::vector<std::int32_t>& visible) {
    const DrawnSpheres drawn = drawn_spheres(trial.scene);
    const CandidateLists lists = build_lists(drawn, trial.scene.camera, trial.size, cpu_tile_costs);
    visible.assign(static_cast<std::size_t>(trial.size.width) * static_cast<std::size_t>(trial.size.height), doubtful_background);
    return Resolver(trial.scene, drawn, trial.size, &lists).certify({0, 0, trial.size.width, trial.size.height}, visible);
}

#ifndef SPHEREVIEW_LONG

TEST(Stress, needs_few_integers_and_shows_what_the_oracle_shows) {
    constexpr int count = 1000;
    std::int64_t in_integers = 0;
    for (const Trial& trial : stress_trials(count, {25, 25})) {
        std::vector<std::int32_t> visible;
        const DecisionCounts counts = certified(trial, visible);
        Random random(seed());
        for (int i = 0; i < (is_sampled(1) ? 12 : 2); ++i) {
            const Pixel at{i < 2 ? 12 : random.whole(0, 24), i == 1 ? 12 : random.whole(0, 24)};
            ASSERT_EQ(visible[static_cast<std::size_t>(at.y * 25 + at.x)], pixel(trial.scene, trial.size, at))
                << trial.name << ", " << at.x << "," << at.y;
        }
        std::cout << trial.name << ": " << counts.exactly << " pixels exactly, " << counts.integer_tests
                  << " spheres in integers\n";
        // A column of exact ties, a row of tangents, and no more.
        EXPECT_LE(counts.integer_tests, 26 * count) << trial.name;
        in_integers += counts.integer_tests;
    }
    EXPECT_GT(in_integers, count);  // or the hardest scenes are missing
}

#elif defined(NDEBUG)

// In time of all cores, whatever else the machine does: twice what two cores may take.
TEST(Stress, takes_less_than_two_seconds_on_two_cores) {
    for (const Trial& trial : stress_trials(5000, {201, 201})) {
        const std::clock_t begin = std::clock();
        std::vector<std::int32_t> visible;
        const DecisionCounts counts = certified(trial, visible);
        const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        std::cout << trial.name << ": " << seconds << " s of all cores; " << counts.exactly << " pixels exactly, "
                  << counts.integer_tests << " spheres in integers\n";
        EXPECT_LT(seconds, 4.0) << trial.name;
    }
}

#endif

}  // namespace

}  // namespace sphereview::oracle

// Compiled with several sets of flags: always the oracle's picture, so the same bytes.
#include <gtest/gtest.h>

#include "cpu/cpu_renderer.hpp"
#include "exact/resolve.hpp"
#include "oracle/difference.hpp"
#include "oracle/oracle.hpp"
#include "oracle/scenes.hpp"

namespace sphereview::oracle {

namespace {

void expect_the_oracles_pictures(const Trials& trials) {
    DecisionCounts counts;
    for (const Trial& trial : trials) {
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        const Block all{0, 0, trial.size.width, trial.size.height};
        std::vector<std::int32_t> visible(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height));
        const CandidateLists lists = build_lists(drawn, trial.scene.camera, trial.size, cpu_tile_costs);
        CpuRenderer(drawn, lists, trial.scene.camera, trial.size).trace(all, visible);
        counts += Resolver(trial.scene, drawn, trial.size, &lists).certify(all, visible);
        ASSERT_EQ(difference(trial, "cpu as in " VARIANT, picture(trial.scene, trial.size), visible), "");
    }
    EXPECT_GT(counts.in_float, 0);
    EXPECT_GT(counts.in_double + counts.exactly, 0);
}

Trials some_of(const Trials& all) {
    Trials some;
    for (std::size_t i = 0; i < all.size(); i += 3) some.push_back(all[i]);
    return some;
}

Trials random(Trial (*make)(std::uint64_t), std::uint64_t count) {
    Trials trials;
    for (std::uint64_t i = 0; i < count; ++i) trials.push_back(make(3000 + i));
    return trials;
}

TEST(Flags, random) { expect_the_oracles_pictures(random(random_trial, 40)); }
TEST(Flags, lattices) { expect_the_oracles_pictures(random(lattice_trial, 100)); }
TEST(Flags, near_misses) { expect_the_oracles_pictures(random(near_miss_trial, 100)); }
TEST(Flags, bit_patterns) { expect_the_oracles_pictures(random(bit_pattern_trial, 200)); }
TEST(Flags, touching) { expect_the_oracles_pictures(some_of(touching_trials())); }
TEST(Flags, tiles) { expect_the_oracles_pictures(some_of(tile_trials())); }
TEST(Flags, stress) { expect_the_oracles_pictures(some_of(stress_trials(20, {15, 15}))); }
TEST(Flags, range) { expect_the_oracles_pictures(some_of(range_trials())); }

}  // namespace

}  // namespace sphereview::oracle

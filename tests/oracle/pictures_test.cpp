// Every pixel of every scene, from all backends, is the oracle's. Set SPHEREVIEW_SEED for other random scenes.
#include <gtest/gtest.h>

#include <iostream>

#include "oracle/backends.hpp"
#include "oracle/oracle.hpp"

namespace sphereview::oracle {

namespace {

void expect_the_oracles_pictures(const Trials& trials) {
    ASSERT_FALSE(trials.empty());
    std::vector<std::vector<std::int32_t>> expected;
    std::size_t tests = 0;
    for (const Trial& trial : trials) {
        ASSERT_FALSE(camera_fault(trial.scene.camera)) << trial.name;
        expected.push_back(picture(trial.scene, trial.size));
        tests += expected.back().size() * trial.scene.spheres.size();
    }
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        DecisionCounts counts;
        int failures = 0;
        for (std::size_t i = 0; i < trials.size() && failures < 3; ++i) {
            const std::string found =
                difference(trials[i], open.description, expected[i], visible_spheres(open, trials[i], true, &counts));
            failures += found.empty() ? 0 : 1;
            EXPECT_EQ(found, "");
        }
        std::cout << open.description << ": " << trials.size() << " scenes, " << tests << " pixel-spheres; pixels decided in float "
                  << counts.in_float << ", in double " << counts.in_double << ", exactly " << counts.exactly << '\n';
    }
}

// In parts, so that tests that run side by side share the work.
class Pictures : public testing::TestWithParam<std::size_t> {
protected:
    static constexpr std::size_t parts = 2;

    static Trials made_by_hand(const Trials& all) {
        Trials part;
        for (std::size_t i = GetParam(); i < all.size(); i += parts) {
            if (is_sampled(i / parts)) part.push_back(all[i]);
        }
        return part;
    }

    static Trials random(Trial (*make)(std::uint64_t), std::size_t count) {
        Trials part;
        for (std::size_t i = GetParam(); i < count; i += parts) {
            if (is_sampled(i / parts)) part.push_back(make(i));
        }
        return part;
    }
};

TEST_P(Pictures, random) { expect_the_oracles_pictures(random(random_trial, 300)); }
TEST_P(Pictures, stress) { expect_the_oracles_pictures(made_by_hand(stress_trials(24, {25, 25}))); }
TEST_P(Pictures, lattices) { expect_the_oracles_pictures(random(lattice_trial, 400)); }
TEST_P(Pictures, near_misses) { expect_the_oracles_pictures(random(near_miss_trial, 600)); }
TEST_P(Pictures, bit_patterns) { expect_the_oracles_pictures(random(bit_pattern_trial, 400)); }
TEST_P(Pictures, touching) { expect_the_oracles_pictures(made_by_hand(touching_trials())); }
TEST_P(Pictures, range) { expect_the_oracles_pictures(made_by_hand(range_trials())); }
TEST_P(Pictures, tiles) { expect_the_oracles_pictures(made_by_hand(tile_trials())); }

// Orthographic: the same scenes, some of each kind, and some that are made for parallel rays.
Trial parallel_random_trial(std::uint64_t seed) { return orthographic(random_trial(seed)); }
Trial parallel_lattice_trial(std::uint64_t seed) { return orthographic(lattice_trial(seed)); }
Trial parallel_bit_pattern_trial(std::uint64_t seed) { return orthographic(bit_pattern_trial(seed)); }

TEST_P(Pictures, orthographic_random) { expect_the_oracles_pictures(random(parallel_random_trial, 200)); }
TEST_P(Pictures, orthographic_lattices) { expect_the_oracles_pictures(random(parallel_lattice_trial, 300)); }
TEST_P(Pictures, orthographic_near_misses) { expect_the_oracles_pictures(random(parallel_near_miss_trial, 300)); }
TEST_P(Pictures, orthographic_bit_patterns) { expect_the_oracles_pictures(random(parallel_bit_pattern_trial, 200)); }
TEST_P(Pictures, orthographic_made_by_hand) {
    Trials all;
    for (const Trials& kind : {touching_trials(), range_trials(), tile_trials(), stress_trials(8, {25, 25})}) {
        for (std::size_t i = 0; i < kind.size(); i += 2) all.push_back(orthographic(kind[i]));
    }
    expect_the_oracles_pictures(made_by_hand(all));
}

INSTANTIATE_TEST_SUITE_P(part, Pictures, testing::Range(std::size_t{0}, std::size_t{2}));

}  // namespace

}  // namespace sphereview::oracle

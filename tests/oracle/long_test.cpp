// Every pixel of full-size pictures. The scenes of 1000 x 1000 take minutes: a program of their own, oracle_long_test
// (label long), which is this file with SPHEREVIEW_LONG defined.
#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <iterator>

#include "formats/scene_format.hpp"
#include "oracle/backends.hpp"
#include "oracle/long_filter.hpp"
#include "oracle/oracle.hpp"
#include "support/folders.hpp"

namespace sphereview::oracle {

namespace {

#ifdef SPHEREVIEW_LONG
constexpr bool is_long = true;
#else
constexpr bool is_long = false;
#endif

Trial shipped_scene(int number) {
    const std::string name = "input" + std::to_string(number) + ".txt";
    std::ifstream file(test::source_file("scenes/") + name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    const std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    return {name, parse_scene(content, name), {1000, 1000}};
}

// The filter is right where it decides, and decides nearly everything.
TEST(LongFilter, is_the_oracles) {
    std::size_t pixels = 0;
    std::size_t undecided = 0;
    Trials trials;
    for (std::uint64_t i = 500; i < 560; ++i) {
        if (!is_sampled(i)) continue;
        for (const auto make : {random_trial, lattice_trial, near_miss_trial, bit_pattern_trial}) trials.push_back(make(i));
    }
    const Trials by_hand = touching_trials();
    for (std::size_t i = 0; i < by_hand.size(); i += 9) trials.push_back(by_hand[i]);
    for (const Trial& trial : trials) {
        const FilteredPicture filtered = filtered_picture(trial.scene, trial.size);
        ASSERT_EQ(difference(trial, "the long double filter", picture(trial.scene, trial.size), filtered.numbers), "");
        pixels += filtered.numbers.size();
        undecided += filtered.by_the_oracle;
    }
    std::cout << undecided << " of " << pixels << " pixels undecided in long double\n";
    EXPECT_LT(undecided, pixels / 10);
}

void expect_the_filters_pictures(const Trials& trials) {
    std::vector<std::vector<std::int32_t>> expected;
    for (const Trial& trial : trials) {
        const FilteredPicture filtered = filtered_picture(trial.scene, trial.size);
        std::cout << trial.name << ": " << filtered.by_the_oracle << " pixels undecided in long double\n";
        Random random(seed());
        for (int i = 0; i < 200; ++i) {
            const Pixel at{random.whole(0, trial.size.width - 1), random.whole(0, trial.size.height - 1)};
            const auto place =
                static_cast<std::size_t>(at.y) * static_cast<std::size_t>(trial.size.width) + static_cast<std::size_t>(at.x);
            ASSERT_EQ(filtered.numbers[place], pixel(trial.scene, trial.size, at)) << trial.name << ", " << at.x << "," << at.y;
        }
        expected.push_back(filtered.numbers);
    }
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            EXPECT_EQ(difference(trials[i], open.description, expected[i], visible_spheres(open, trials[i])).substr(0, 4000), "");
        }
    }
}

// The shipped scenes; a quick look at the first one is for every run.
TEST(FullSizeOracle, shipped_scenes) {
    Trials trials;
    for (int number = 1; number <= (is_long ? 4 : 1); ++number) trials.push_back(shipped_scene(number));
    if (!is_long) trials.front().size = {500, 500};
    expect_the_filters_pictures(trials);
}

#ifdef SPHEREVIEW_LONG

Trial crowded_trial(int count, Random& random) {
    Trial trial{std::to_string(count) + " spheres, SPHEREVIEW_SEED=" + std::to_string(seed()), {}, {1000, 1000}};
    if (count % 3 == 0) trial.scene.camera = random_camera(random, 100.0);
    const Camera& camera = trial.scene.camera;
    for (int i = 0; i < count; ++i) {
        const double depth = random.between(0.5, 10.0);
        const double across = random.between(-1.0, 1.0);
        const double upward = random.between(-1.0, 1.0);
        const glm::dvec3 ray = camera.center - camera.eye + across * camera.right + upward * camera.up;
        const double edge =
            std::sqrt(camera.right.x * camera.right.x + camera.right.y * camera.right.y + camera.right.z * camera.right.z);
        trial.scene.spheres.push_back({camera.eye + depth * ray, random.between(0.3, 2.0) * depth * edge / std::sqrt(count)});
    }
    return trial;
}

class LongPictures : public testing::TestWithParam<int> {};

TEST_P(LongPictures, crowded) {
    Random random(seed() + static_cast<std::uint64_t>(GetParam()));
    expect_the_filters_pictures({crowded_trial(GetParam(), random)});
}

TEST_P(LongPictures, degenerate) {
    Trials trials;
    for (const auto make : {random_trial, lattice_trial, near_miss_trial}) {
        trials.push_back(make(static_cast<std::uint64_t>(GetParam()) + 7000));
        trials.back().size = {399, 401};
    }
    expect_the_filters_pictures(trials);
}

INSTANTIATE_TEST_SUITE_P(spheres, LongPictures, testing::Values(4, 21, 100, 300, 1000));

#endif

}  // namespace

}  // namespace sphereview::oracle

// More spheres than the oracle can try for every pixel: lists of several sizes of tiles, and very long ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "cpu/cpu_renderer.hpp"
#include "oracle/backends.hpp"
#include "oracle/long_filter.hpp"
#include "support/trials.hpp"

namespace sphereview::oracle {

namespace {

Trials several_levels_trials() {
    Trials trials = {crowded_tiles_trial({827, 9}, 2000, 4), crowded_tiles_trial({411, 17}, 3000, 4)};
    if (!test::is_sanitized) {
        trials.push_back(crowded_tiles_trial({83, 61}, 5000, 8));
        trials.push_back(crowded_tiles_trial({29, 233}, 10'000, 20));
    }
    return trials;
}

TEST(Tiles, of_several_sizes) {
    const Trials trials = several_levels_trials();
    std::size_t most_on_gpu = 0;
    std::size_t most_on_cpu = 0;
    std::vector<std::vector<std::int32_t>> expected;
    for (const Trial& trial : trials) {
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        const auto levels = [&](const TileCosts& costs) {
            return build_lists(drawn, trial.scene.camera, trial.size, costs).levels.size();
        };
        most_on_gpu = std::max(most_on_gpu, levels(with_small_budget(gpu_tile_costs)));
        most_on_cpu = std::max(most_on_cpu, levels(with_small_budget(cpu_tile_costs)));
        expected.push_back(filtered_picture(trial.scene, trial.size).numbers);
    }
    EXPECT_GE(most_on_gpu, test::is_sanitized ? 2U : 3U);
    EXPECT_GE(most_on_cpu, 2U);
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        open.tile_costs = with_small_budget(open.tile_costs);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            EXPECT_EQ(difference(trials[i], open.description, expected[i], visible_spheres(open, trials[i])).substr(0, 4000), "");
        }
    }
}

// All in a square of so many pixels at (24, 16), a corner of tiles of any size up to 8.
Trial crowd_in_one_tile(const std::string& name, int side, double least, double most) {
    Random random(seed() + static_cast<std::uint64_t>(side));
    constexpr int count = test::is_sanitized ? 10'000 : 100'000;
    Trial trial{std::to_string(count) + " spheres in one tile, " + name, {}, {203, 150}};
    const Camera& camera = trial.scene.camera;
    const double m = trial.size.shorter_side();
    for (int i = 0; i < count; ++i) {
        const RayCoefficients corner = ray_coefficients(trial.size, {24, 16});
        const double across = static_cast<double>(corner.across) - 1.0 + 2.0 * side * random.unit();
        const double upward = static_cast<double>(corner.upward) + 1.0 - 2.0 * side * random.unit();
        const glm::dvec3 ray = camera.center + across / m * camera.right + upward / m * camera.up;
        const double depth = random.of_size(0.5, 500.0);
        const double radius = random.between(least, most) * depth * 2.0 / m * glm::length(camera.right);
        trial.scene.spheres.push_back({camera.eye + depth * ray, radius});
    }
    // Behind them all, so that walks that end too late are no slower for it than those that end too soon.
    trial.scene.spheres.push_back({{0, 0, 2e7}, 1.5e7});
    return trial;
}

TEST(Tiles, with_a_hundred_thousand_spheres_in_one) {
    const Trials trials = {crowd_in_one_tile("specks", 8, 1e-6, 0.02), crowd_in_one_tile("larger than pixels", 7, 0.1, 2.0),
                           crowd_in_one_tile("all at four pixels", 2, 1e-3, 0.3)};
    std::vector<std::vector<std::int32_t>> first;
    for (const Backend backend : tested_backends()) {
        OpenBackend open = opened(backend);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            const std::vector<std::int32_t> found = visible_spheres(open, trials[i]);
            if (first.size() <= i) {
                first.push_back(found);
            } else {
                ASSERT_TRUE(found == first[i]) << trials[i].name << ", " << open.description;
            }
        }
    }
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Trial& trial = trials[i];
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        const Resolver without_lists(trial.scene, drawn, trial.size);
        for (int y = 12; y < 28; ++y) {
            for (int x = 20; x < 36; ++x) {
                DecisionLevel level{};
                const auto place = static_cast<std::size_t>(y * trial.size.width + x);
                ASSERT_EQ(first[i][place], without_lists.resolve({x, y}, level)) << trial.name << ", " << x << "," << y;
            }
        }
    }
}

}  // namespace

}  // namespace sphereview::oracle

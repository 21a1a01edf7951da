// The light of every pixel against the oracle's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "light/lighting.hpp"
#include "oracle/light_oracle.hpp"
#include "oracle/light_scenes.hpp"
#include "oracle/oracle.hpp"
#include "oracle/scenes.hpp"
#include "scene/vectors.hpp"
#include "support/spheres.hpp"
#include "support/trials.hpp"

namespace sphereview::oracle {

namespace {

constexpr std::size_t most_work = 30'000;  // spheres times pixels: the oracle is slow
#ifdef VARIANT
constexpr std::size_t step = 3;  // through the scenes: with other flags of the compiler a third of them
#else
constexpr std::size_t step = 1;
#endif

// The number of pixels whose light differs from the oracle's by the rules; `what` says where the first is.
int differences(const LitTrial& lit, const LightRules& rules, std::string& what) {
    const Scene& scene = lit.trial.scene;
    const PictureSize size = lit.trial.size;
    const std::vector<std::int32_t> visible = picture(scene, size);
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Lighting lighting(scene, drawn, scene.camera, size, lit.side, lit.light);
    const std::vector<LightVector> found = lighting.light({0, 0, size.width, size.height}, visible);
    std::vector<std::vector<glm::dvec3>> directions;
    for (int set = 0; set < lit.side * lit.side; ++set) {
        directions.emplace_back();
        for (const DirectedLight& light : lighting.lights(set)) directions.back().push_back(light.direction);
    }
    std::vector<LightVector> expected(visible.size());
    parallel_for(visible.size(), [&](std::size_t i) {
        if (visible[i] < 0) return;
        const Pixel pixel{static_cast<int>(i) % size.width, static_cast<int>(i) / size.width};
        const int set = pixel.y % lit.side * lit.side + pixel.x % lit.side;
        const std::vector<bool> shining = shines(scene, size, pixel, visible[i], directions[static_cast<std::size_t>(set)], rules);
        for (std::size_t k = 0; k < shining.size(); ++k) {
            if (shining[k]) expected[i] += lighting.lights(set)[k].share;
        }
    });
    int count = 0;
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (found[i] == expected[i]) continue;
        if (count++ == 0) {
            what = lit.trial.name + ": pixel " + std::to_string(static_cast<int>(i) % size.width) + "," +
                   std::to_string(static_cast<int>(i) / size.width) + " of sphere " + std::to_string(visible[i]);
        }
    }
    return count;
}

void expect_the_oracles_light(const LitTrial& lit) {
    std::string what;
    EXPECT_EQ(differences(lit, {}, what), 0) << what;
}

void expect_the_oracles_light(const Trials& trials) {
    for (std::size_t i = 0; i < trials.size(); i += step) {
        const std::size_t spheres = trials[i].scene.spheres.size();
        const auto pixels = static_cast<std::size_t>(trials[i].size.width) * static_cast<std::size_t>(trials[i].size.height);
        if (!is_sampled(i) || spheres * pixels > most_work) continue;
        expect_the_oracles_light(with_light(trials[i], seed() + i));
    }
}

Trials made(Trial (*make)(std::uint64_t), std::uint64_t count) {
    Trials trials;
    for (std::uint64_t i = 0; i < count; ++i) trials.push_back(make(seed() + i));
    return trials;
}

TEST(Light, edges) {
    for (const LitTrial& lit : light_edges()) expect_the_oracles_light(lit);
}
TEST(Light, crowds) {
    const std::vector<LitTrial> all = light_crowds();
    for (std::size_t i = 0; i < all.size(); i += test::is_sanitized ? 3 : 1) expect_the_oracles_light(all[i]);
}
TEST(Light, random) { expect_the_oracles_light(made(random_trial, 30)); }
TEST(Light, lattices) { expect_the_oracles_light(made(lattice_trial, 60)); }
TEST(Light, near_misses) { expect_the_oracles_light(made(near_miss_trial, 30)); }
TEST(Light, bit_patterns) { expect_the_oracles_light(made(bit_pattern_trial, 40)); }
TEST(Light, touching) { expect_the_oracles_light(touching_trials()); }
TEST(Light, range) { expect_the_oracles_light(range_trials()); }
TEST(Light, tiles) { expect_the_oracles_light(tile_trials()); }

TEST(Light, orthographic) {
    Trials trials;
    for (std::uint64_t i = 0; i < 40; ++i) {
        trials.push_back(orthographic(i % 2 == 0 ? random_trial(seed() + i) : lattice_trial(seed() + i)));
        if (i % 4 == 0) trials.push_back(parallel_near_miss_trial(seed() + i));
    }
    for (const LitTrial& edge : light_edges()) trials.push_back(orthographic(edge.trial));
    expect_the_oracles_light(trials);
}

// A picture without sky is black in the sun's shadow.
TEST(Light, of_the_sun_alone) {
    for (std::uint64_t i = 0; i < 20; ++i) {
        LitTrial lit = with_light(i % 2 == 0 ? random_trial(seed() + i) : lattice_trial(seed() + i), seed() + i);
        lit.light.sky = 0.0;
        const auto pixels = static_cast<std::size_t>(lit.trial.size.width) * static_cast<std::size_t>(lit.trial.size.height);
        if (lit.trial.scene.spheres.size() * pixels <= most_work) expect_the_oracles_light(lit);
    }
}

TEST(Light, of_many_lights) {
    LitTrial lit = with_light(lattice_trial(seed()), seed());
    lit.trial.size = {11, 9};
    lit.light.lights = 256;
    expect_the_oracles_light(lit);
}

TEST(Light, samples_have_sets_of_their_own) {
    for (const int side : {2, 4}) {
        LitTrial lit = with_light(lattice_trial(seed()), seed());
        lit.trial.size = sampled_size({7, 5}, side);
        lit.side = side;
        expect_the_oracles_light(lit);
    }
}

// Whoever looks on sees the light get finer, about as bright from the beginning; and it ends as without anyone.
TEST(Light, previews_are_as_bright_as_all) {
    Scene scene = scene_of({{{0.0, 0.0, 200.0}, 60.0, {}, false}, {{-20.0, 30.0, 120.0}, 8.0, {}, false}});
    constexpr PictureSize size{40, 30};
    constexpr Block whole{0, 0, size.width, size.height};
    const std::vector<std::int32_t> visible = picture(scene, size);
    const DrawnSpheres drawn = drawn_spheres(scene);
    // The sum of n.B. Rays through pixels in double, which is enough for a mean.
    const auto brightness = [&](std::span<const LightVector> light) {
        double sum = 0.0;
        for (std::size_t i = 0; i < visible.size(); ++i) {
            if (visible[i] < 0) continue;
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(visible[i])];
            const Pixel pixel{static_cast<int>(i) % size.width, static_cast<int>(i) / size.width};
            const auto [across, upward] = ray_coefficients(size, pixel);
            const double shorter = size.shorter_side();
            const glm::dvec3 ray =
                unit({50.0 * static_cast<double>(across) / shorter, 50.0 * static_cast<double>(upward) / shorter, 100.0});
            const double along = dot(sphere.center, ray);
            const double t =
                along - std::sqrt(std::max(along * along - dot(sphere.center, sphere.center) + sphere.radius * sphere.radius, 0.0));
            const glm::dvec3 normal = (t * ray - sphere.center) / sphere.radius;
            sum += std::max(
                dot(normal, {static_cast<double>(light[i].x), static_cast<double>(light[i].y), static_cast<double>(light[i].z)}),
                0.0);
        }
        return sum;
    };
    for (const std::optional<Sun>& sun : {std::optional<Sun>(), std::optional(Sun{{1.0, 2.0, -2.0}, 2.0})}) {
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = 128, .sky = 1.0, .sun = sun});
        const std::vector<LightVector> all = lighting.light(whole, visible);
        std::vector<double> previews;
        const LightPreviews shown{
            .show = [&](std::span<const LightVector> light, double) { previews.push_back(brightness(light)); },
            .fewest = 8,
            .first_after = 0.0,
            .every = 0.0};
        EXPECT_EQ(lighting.light(whole, visible, nullptr, &shown), all);
        EXPECT_GE(previews.size(), 2U);
        for (const double preview : previews) EXPECT_NEAR(preview / brightness(all), 1.0, 0.1);

        // Or they say how much is missing, of the sky.
        const Lighting under_sun(scene, drawn, scene.camera, size, 1, {.lights = 16, .sky = 0.0, .sun = sun});
        const double of_sun = sun ? brightness(under_sun.light(whole, visible)) : 0.0;
        std::vector<double> parts;
        const LightPreviews partly{.show =
                                       [&](std::span<const LightVector> light, double missing) {
                                           parts.push_back(missing);
                                           const double sky = (brightness(light) - of_sun) / (brightness(all) - of_sun);
                                           EXPECT_NEAR(sky, 1.0 - missing, 0.1);
                                       },
                                   .as_bright = false,
                                   .first_after = 0.0,
                                   .every = 0.0};
        EXPECT_EQ(lighting.light(whole, visible, nullptr, &partly), all);
        ASSERT_GE(parts.size(), 2U);
        EXPECT_GT(parts.front(), 0.5);
        EXPECT_TRUE(std::ranges::is_sorted(parts, std::ranges::greater()));
    }
}

// Points that double cannot place are lit with all others, and keep nobody from looking on.
TEST(Light, previews_have_points_that_double_cannot_place) {
    Scene scene = lit_middle();
    scene.spheres.push_back({{0.0, 0.0, 1e200}, 9e199, {0, 255, 0}, false});
    const Trial trial{"far and huge", scene, {15, 15}};
    expect_the_oracles_light({trial, sky_and_sun(slanting)});
    const std::vector<std::int32_t> visible = picture(scene, trial.size);
    ASSERT_TRUE(std::ranges::count(visible, 1) > 0);
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Lighting lighting(scene, drawn, scene.camera, trial.size, 1, {.lights = 64, .sky = 1.0, .sun = {}});
    int previews = 0;
    const LightPreviews shown{
        .show = [&](std::span<const LightVector>, double) { ++previews; }, .fewest = 8, .first_after = 0.0, .every = 0.0};
    lighting.light({0, 0, 15, 15}, visible, nullptr, &shown);
    EXPECT_GE(previews, 1);
}

// What was kept of a picture is its light in any other strengths, block by block.
TEST(Light, that_is_kept_is_as_decided_anew) {
    const Sun sun{{1.0, 2.0, -2.0}, 1.5};
    const Light decided{.lights = 37, .sky = 1.0, .key = 1.0, .sun = sun};
    const std::vector<Light> others = {
        decided,
        {.lights = 37, .sky = 0.3, .key = 0.6, .sun = Sun{sun.direction, 0.25}},
        {.lights = 37, .sky = 1.0, .key = 0.0, .sun = std::nullopt},
        {.lights = 37, .sky = 0.0, .key = 1.0, .sun = sun},
    };
    for (const int side : {1, 2, 4}) {
        Trial trial = random_trial(seed() + static_cast<std::uint64_t>(side));
        // So far behind all that its points are lit apart from the others.
        const glm::dvec3 ahead = trial.scene.camera.center - trial.scene.camera.eye;
        trial.scene.spheres.push_back({trial.scene.camera.eye + 1e9 * ahead, 9e8 * largest_of(ahead), {}, false});
        const PictureSize size = sampled_size({19, 13}, side);
        const std::vector<std::int32_t> visible = picture(trial.scene, size);
        const DrawnSpheres drawn = drawn_spheres(trial.scene);
        const Camera& camera = trial.scene.camera;
        // Two blocks, as high as whole pixels are.
        const int middle = size.height / side / 2 * side;
        const std::vector<Block> blocks = {{0, 0, size.width, middle}, {0, middle, size.width, size.height - middle}};
        const auto of_block = [&](const Block& block) {
            const auto width = static_cast<std::size_t>(block.width);
            return std::span(visible).subspan(static_cast<std::size_t>(block.y) * width,
                                              static_cast<std::size_t>(block.height) * width);
        };
        const Lighting lighting(trial.scene, drawn, camera, size, side, decided);
        KeptLight kept(std::size_t{1} << 20);
        kept.begin(lighting.sets(), side);
        for (const Block& block : blocks) lighting.light(block, of_block(block), nullptr, nullptr, &kept);
        kept.finish();
        ASSERT_TRUE(kept.is_complete());
        ASSERT_EQ(kept.pieces().size(), blocks.size());
        for (const Light& light : others) {
            const Lighting anew(trial.scene, drawn, camera, size, side, light);
            const auto shares = kept.shares(anew.sets());
            ASSERT_TRUE(shares);
            for (std::size_t i = 0; i < blocks.size(); ++i) {
                const std::vector<LightVector> expected = anew.light(blocks[i], of_block(blocks[i]));
                EXPECT_EQ(kept.light(kept.pieces()[i], *shares), expected) << "side " << side << ", block " << i;
            }
        }
        // Where a light comes from another direction, or there are others, something must be decided.
        for (const Light& light : {Light{.lights = 37, .sun = Sun{{1.0, 2.0, -2.5}, 1.5}}, Light{.lights = 38, .sun = {}}}) {
            EXPECT_FALSE(kept.shares(light_sets(light, 1, camera, side)));
        }
        // No more is kept than there is room for.
        KeptLight small(kept.bytes() - 1);
        small.begin(lighting.sets(), side);
        for (const Block& block : blocks) lighting.light(block, of_block(block), nullptr, nullptr, &small);
        small.finish();
        EXPECT_FALSE(small.is_complete());
        EXPECT_EQ(small.bytes(), 0U);
    }
}

// Blocks have the light of the whole picture.
TEST(Light, blocks) {
    const Trial trial = random_trial(seed());
    const std::vector<std::int32_t> visible = picture(trial.scene, trial.size);
    const DrawnSpheres drawn = drawn_spheres(trial.scene);
    const Lighting lighting(trial.scene, drawn, trial.scene.camera, trial.size, 1, {.lights = 33, .sky = 1.0, .sun = {}});
    const int width = trial.size.width;
    const std::vector<LightVector> all = lighting.light({0, 0, width, trial.size.height}, visible);
    std::vector<LightVector> rows;
    for (int y = 0; y < trial.size.height; ++y) {
        const std::span row(&visible[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)],
                            static_cast<std::size_t>(width));
        const std::vector<LightVector> lit = lighting.light({0, y, width, 1}, row);
        rows.insert(rows.end(), lit.begin(), lit.end());
    }
    EXPECT_EQ(all, rows);
}

// Other flags of the compiler (flags/) say the same of the oracle; and sanitizers, with which it takes long, find nothing that they
// do not find above.
#if !defined(VARIANT) && !defined(SPHEREVIEW_SANITIZED)

// Each mistake in the definition shows in at least one of the scenes.
TEST(Light, mistakes_are_noticed) {
    const std::vector<LitTrial> trials = light_edges();
    const auto noticed = [&](const LightRules& rules) {
        std::string what;
        return std::ranges::any_of(trials, [&](const LitTrial& lit) { return differences(lit, rules, what) > 0; });
    };
    EXPECT_TRUE(noticed({.tangent_blocks = false}));
    EXPECT_TRUE(noticed({.edge_is_dark = false}));
    EXPECT_TRUE(noticed({.spheres_of_eye_block = true}));
    EXPECT_TRUE(noticed({.only_towards_the_light = false}));
    EXPECT_TRUE(noticed({.normal_turned_to_eye = false}));
    EXPECT_TRUE(noticed({.hidden_blocks = true}));
}

#endif

}  // namespace

}  // namespace sphereview::oracle

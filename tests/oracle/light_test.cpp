// The light of every pixel against the oracle's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/mat3x3.hpp>
#include <iostream>
#include <string>

#include "base/parallel.hpp"
#include "exact/resolve.hpp"
#include "light/light_tiles.hpp"
#include "light/lighting.hpp"
#include "oracle/light_oracle.hpp"
#include "oracle/oracle.hpp"
#include "oracle/random.hpp"
#include "oracle/scenes.hpp"
#include "scene/vectors.hpp"
#include "support/trials.hpp"

namespace sphereview::oracle {

namespace {

constexpr std::size_t most_work = 30'000;  // spheres times pixels: the oracle is slow

struct LitTrial {
    Trial trial;
    Light light;
    int side = 1;  // points along the side of a pixel; the trial's size is in points
};

// Directions that lattices have spheres, tangents and edges in.
glm::dvec3 whole_direction(Random& random) {
    glm::dvec3 v{0.0};
    while (v == glm::dvec3(0.0)) {
        v = {random.whole(-2, 2), random.whole(-2, 2), random.whole(-2, 2)};
    }
    return v;
}

LitTrial with_light(Trial trial, std::uint64_t seed) {
    Random random(seed);
    const glm::dvec3 direction = random.chance(0.6) ? whole_direction(random) : random.in_cube(1.0);
    return {std::move(trial), {.lights = 16, .sky = 1.0, .sun = Sun{direction, 1.0}}};
}

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
    for (std::size_t i = 0; i < trials.size(); ++i) {
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

// The middle pixel sees the point (0, 0, 180), the light is in the direction (1, 0, -1).
Scene lit_middle() {
    Scene scene;
    scene.spheres.push_back({{0.0, 0.0, 200.0}, 20.0, {255, 0, 0}});
    return scene;
}
constexpr glm::dvec3 slanting{1.0, 0.0, -1.0};

// What the definition leaves to chance: edges of shadows, tangent lines, normals at right angles, spheres that touch or hold
// others.
std::vector<LitTrial> edges() {
    std::vector<LitTrial> all;
    const auto add = [&](const std::string& name, Scene scene, const glm::dvec3& direction) {
        for (const int side : {9, 21}) {
            all.push_back({{name, scene, {side, side}}, {.lights = 16, .sky = 1.0, .sun = Sun{direction, 1.0}}});
        }
    };
    Scene scene = lit_middle();
    add("alone", scene, slanting);
    add("light at a right angle to the normal", scene, {0.0, 1.0, 0.0});
    add("light behind", scene, {0.0, 0.0, 1.0});
    scene.spheres.push_back({{40.0, 5.0, 140.0}, 5.0, {0, 255, 0}});
    add("line to the light touches a sphere", scene, slanting);
    scene.spheres[1].center = {-40.0, 5.0, 220.0};
    add("line away from the light touches a sphere", scene, slanting);
    scene.spheres[1] = {{40.0, 0.0, 140.0}, 5.0, {0, 255, 0}};
    add("sphere in the way", scene, slanting);
    scene.spheres[1].hidden = true;
    add("hidden sphere in the way", scene, slanting);
    scene.spheres[1] = {{0.0, 0.0, 0.0}, 500.0, {0, 255, 0}};
    add("all in a sphere that holds the eye", scene, slanting);
    scene.spheres[1] = {{0.0, 0.0, 40.0}, 40.0, {0, 255, 0}};
    add("the eye on a sphere", scene, slanting);
    scene.spheres[1] = {{0.0, 40.0, 200.0}, 20.0, {0, 255, 0}};
    add("touching spheres", scene, {0.0, 1.0, 0.0});
    add("touching spheres, light across", scene, {0.0, 0.0, -1.0});
    scene.spheres[1] = scene.spheres[0];
    add("equal spheres", scene, slanting);
    scene.spheres[1].radius = std::nextafter(20.0, 0.0);
    add("nearly equal spheres", scene, slanting);
    scene.spheres[1] = {{0.0, 5.0, 200.0}, 15.0, {0, 255, 0}};
    add("a sphere within, touching", scene, {0.0, 1.0, 0.0});
    scene.spheres[1] = {{10.0, 0.0, 190.0}, 15.0, {0, 255, 0}};
    add("spheres that cross", scene, {1.0, 0.0, 0.0});
    scene = Scene{};
    scene.spheres.push_back({{0.0, 0.0, 0.0}, 300.0, {255, 0, 0}});
    scene.spheres.push_back({{30.0, 30.0, 200.0}, 40.0, {0, 255, 0}});
    add("in a room", scene, {0.0, 0.0, -1.0});
    for (const double factor : {1e-150, 1e-40, 1e30, 1e120}) {
        scene = lit_middle();
        scene.spheres.push_back({{40.0, 5.0, 140.0}, 5.0, {0, 255, 0}});
        scene.spheres.push_back({{10.0, -20.0, 160.0}, 10.0, {0, 0, 255}});
        for (Sphere& sphere : scene.spheres) sphere = {sphere.center * factor, sphere.radius * factor, sphere.color};
        for (glm::dvec3* v : {&scene.camera.center, &scene.camera.right, &scene.camera.up}) *v *= factor;
        add("scaled by " + std::to_string(factor), scene, slanting);
    }
    scene = lit_middle();
    scene.spheres.push_back({{0.0, -1e9 - 20.0, 200.0}, 1e9, {0, 255, 0}});
    scene.spheres.push_back({{1e160, 0.0, -1e160}, 1e158, {0, 255, 0}});
    scene.spheres.push_back({{3.0, 3.0, 170.0}, 1e-200, {0, 255, 0}});
    add("sizes far apart", scene, slanting);
    return all;
}

// Ordinary spheres in the middle of the picture, among others that are farther away or larger by many orders of magnitude.
struct Surroundings {
    std::string name;
    Scene scene;
};

std::vector<Surroundings> surroundings(int spheres, int others) {
    Random random(seed());
    Scene ordinary;
    for (int i = 0; i < spheres; ++i) {
        const glm::dvec3 center = random.in_cube(60.0) + glm::dvec3(0.0, 0.0, 220.0);
        ordinary.spheres.push_back({center, 4.0 + i % 9, {255, 0, 0}, false});
    }
    std::vector<Surroundings> all;
    all.push_back({"nothing around", ordinary});
    for (const double distance : {1e7, 1e15, 1e190}) {
        Surroundings far{"spheres at " + std::to_string(distance), ordinary};
        for (int i = 0; i < others; ++i) {
            const glm::dvec3 center = 0.1 * distance * random.in_cube(1.0) + glm::dvec3(0.0, distance, 0.0);
            far.scene.spheres.push_back({center, 0.1 * distance, {0, 255, 0}, false});
        }
        all.push_back(far);
    }
    for (const double distance : {1e6, 1e10, 1e20, 1e200}) {
        Surroundings background{"before a sphere at " + std::to_string(distance), ordinary};
        background.scene.spheres.push_back({{0.0, 0.0, distance}, 0.9 * distance, {0, 0, 255}, false});
        all.push_back(background);
    }
    for (const double factor : {1e-140, 1e160}) {
        Surroundings scaled{"scaled by " + std::to_string(factor), ordinary};
        for (Sphere& sphere : scaled.scene.spheres) sphere = {sphere.center * factor, sphere.radius * factor, sphere.color};
        Camera& camera = scaled.scene.camera;
        for (glm::dvec3* v : {&camera.eye, &camera.center, &camera.right, &camera.up}) *v *= factor;
        all.push_back(scaled);
    }
    return all;
}

// Spheres that each cover the whole plane of any light, before few that are seen; and spheres nearly in one place, or quite: lists
// that would be endless.
std::vector<LitTrial> crowds() {
    std::vector<LitTrial> all;
    Random random(seed());
    const auto add = [&](const std::string& name, const Scene& scene, PictureSize size, const glm::dvec3& direction) {
        all.push_back({{name, scene, size}, {.lights = 16, .sky = 1.0, .sun = Sun{direction, 1.0}}});
    };
    for (const bool shadowed : {false, true}) {
        Scene scene = lit_middle();
        for (int i = 0; i < 12; ++i) {
            scene.spheres.push_back({random.in_cube(60.0) + glm::dvec3(0.0, 0.0, 220.0), 3.0 + i, {0, 255, 0}, false});
        }
        for (int i = 0; i < 1000; ++i) {
            const double turn = i / 1000.0;
            // Above them all, or behind, where no light comes through.
            const glm::dvec3 center{900.0 * turn, 4000.0 - 500.0 * turn, (shadowed ? 2000.0 : 4000.0) + 700.0 * turn};
            scene.spheres.push_back({center, 3000.0 + turn, {0, 0, 255}, false});
        }
        add(shadowed ? "a thousand huge spheres around" : "a thousand huge spheres above", scene, {7, 5}, {0.0, 1.0, 0.1});
    }
    for (const double apart : {0.0, 1e-9, 1e-13}) {
        Scene scene = lit_middle();
        for (int i = 0; i < 400; ++i) {
            const glm::dvec3 center{40.0 + apart * (i % 19), apart * (i % 17), 140.0 + apart * (i % 13)};
            scene.spheres.push_back({center, 25.0 + apart * (i % 11), {0, 255, 0}, false});
        }
        add("spheres " + std::to_string(apart) + " apart", scene, {13, 9}, slanting);
    }
    for (const Surroundings& around : surroundings(20, 30)) {
        add(around.name, around.scene, {13, 9}, slanting);
        all.push_back({orthographic(all.back().trial), all.back().light});
    }
    return all;
}

// The sets of lights are what they were when these numbers were written, with every compiler.
TEST(LightSet, is_the_same_everywhere) {
    const auto sum = [](const std::vector<DirectedLight>& lights) {
        std::uint64_t hash = 0;
        for (const DirectedLight& light : lights) {
            for (const double component : {light.direction.x, light.direction.y, light.direction.z}) {
                hash = hash * 0x100000001b3U + static_cast<std::uint64_t>(static_cast<std::int64_t>(component));
            }
            for (const std::int32_t part : {light.share.x, light.share.y, light.share.z}) {
                hash = hash * 0x100000001b3U + static_cast<std::uint64_t>(part);
            }
        }
        return hash;
    };
    EXPECT_EQ(sum(light_set({}, 16, {}, 0)), 7235032799401254674U);
    EXPECT_EQ(sum(light_set({}, 255, {}, 7)), 12563828551802134336U);
    EXPECT_EQ(sum(light_set({.lights = {}, .sky = 0.5, .sun = Sun{{3.0, -4.0, 12.0}, 0.7}}, 1024, {}, 15)), 9618890243853199149U);
}

// A free surface that faces the key has the brightness 1.07, whatever the number of lights; so has each turned set.
TEST(LightSet, is_as_bright_whatever_its_number) {
    for (const int lights : {16, 17, 64, 255, 256, 1024}) {
        for (int set = 0; set < turned_sets; ++set) {
            const std::vector<DirectedLight> all = light_set({}, lights, {}, set);
            EXPECT_EQ(all.size(), static_cast<std::size_t>(lights));
            const glm::dvec3 key = glm::dvec3(-0.45, 0.75, -0.55) / std::sqrt(0.45 * 0.45 + 0.75 * 0.75 + 0.55 * 0.55);
            double brightness = 0.0;
            for (const DirectedLight& light : all) {
                const glm::dvec3 l(light.share.x, light.share.y, light.share.z);
                const double part = (key.x * l.x + key.y * l.y + key.z * l.z) / light_one;
                if (part > 0.0) brightness += part;
            }
            EXPECT_NEAR(brightness, 1.07, lights < 20 ? 0.25 : lights < 100 ? 0.05 : 0.02) << lights << " lights, set " << set;
        }
    }
}

// No sum of shares leaves 32 bits.
TEST(LightSet, sums_fit) {
    for (const int lights : {fewest_lights, 64, most_lights}) {
        double sum = 0.0;
        for (const DirectedLight& light :
             light_set({.lights = {}, .sky = most_sky, .sun = Sun{{1.0, 0.0, 0.0}, strongest_sun}}, lights, {}, 3)) {
            sum += std::sqrt(std::pow(light.share.x, 2.0) + std::pow(light.share.y, 2.0) + std::pow(light.share.z, 2.0));
        }
        EXPECT_LT(sum, 2147483647.0);
    }
}

TEST(LightSet, beginnings_are_spread_evenly) {
    const std::vector<DirectedLight> all = light_set({}, 256, {}, 0);
    for (const std::size_t count : {16U, 32U, 64U, 128U}) {
        glm::dmat3 sum(0.0);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 l = all[i].direction / 32767.0;
            for (int row = 0; row < 3; ++row) sum[row] += l[row] * l / static_cast<double>(count);
        }
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                EXPECT_NEAR(sum[row][column], row == column ? 1.0 / 3.0 : 0.0, count < 64 ? 0.15 : 0.06) << count;
        }
    }
}

TEST(LightSet, lights_that_add_nothing_are_left_out) {
    EXPECT_EQ(light_set({.lights = {}, .sky = 0.0, .sun = Sun{}}, 64, {}, 0).size(), 1U);
    EXPECT_TRUE(light_set({.lights = {}, .sky = 0.0, .sun = {}}, 64, {}, 0).empty());
}

TEST(Light, edges) {
    for (const LitTrial& lit : edges()) expect_the_oracles_light(lit);
}
TEST(Light, crowds) {
    const std::vector<LitTrial> all = crowds();
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
    for (const LitTrial& edge : edges()) trials.push_back(orthographic(edge.trial));
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

// What LightTiles says of all pixels and one light, taken apart so that tests may change what it trusts.
struct Doubts {
    LightTileLimits limits{};
    bool spheres = true;  // else no sphere's place is in doubt
};

// The number of pixels of which LightTiles says otherwise than the oracle. `tiles_across`: how many there were in the end.
int differences(const Trial& trial, const glm::dvec3& direction, const Doubts& doubts, std::size_t& tiles_across) {
    const Scene& scene = trial.scene;
    const PictureSize size = trial.size;
    const Block whole{0, 0, size.width, size.height};
    const std::vector<std::int32_t> visible = picture(scene, size);
    const DrawnSpheres drawn = drawn_spheres(scene);
    std::vector<EyeSide> sides(scene.spheres.size(), EyeSide::outside);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (!std::ranges::binary_search(drawn.gone, i)) sides[static_cast<std::size_t>(drawn.number(i))] = drawn.side(i);
    }
    const SpatialGrid grid(scene, drawn);
    const std::vector<std::uint32_t> order = spatial_order(scene, drawn, grid);
    const HitPlaces places(scene.camera, size);
    const LitPoints points =
        lit_points(scene, places, sides, whole, visible, 1, shown_places(scene, grid, whole, visible, 1), nullptr);
    Blockers all = blockers(scene, drawn, order, sides, places, points);
    if (!doubts.spheres) all.doubt_of_all = all.doubt_of_size = 0.0F;
    const PointTrees trees = point_trees(drawn, order, sides, points, all);
    const LitScene lit_scene{scene, drawn, order, places, sides, whole, visible, points, all, trees};
    LightTiles tiles(doubts.limits);
    const std::span<const std::uint64_t> lit = tiles.lit(lit_scene, 0, direction);
    tiles_across = tiles.tiles_across();
    EXPECT_GT(points.size(), 0U);
    int count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool found = (lit[i / 64] >> i % 64 & 1U) != 0;
        if (found != shines(scene, size, lit_scene.pixel(i), lit_scene.number(i), {&direction, 1}).front()) ++count;
    }
    return count;
}

// Many discs of all sizes.
Trial crowded() {
    Random random(seed());
    Trial trial{"crowded", {}, {15, 13}};
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 center = random.in_cube(70.0) + glm::dvec3(0.0, 0.0, 200.0);
        trial.scene.spheres.push_back({center, 2.0 + i % 30, {}, false});
    }
    return trial;
}

// Larger tiles, before lists are made and because they came out too long.
TEST(Light, larger_tiles_find_the_same) {
    std::size_t across = 0;
    EXPECT_EQ(differences(crowded(), slanting, {}, across), 0);
    EXPECT_EQ(across, 128U);
    LightTileLimits limits;
    for (const double touched : {0x1p12, 0x1p8, 1.0}) {
        limits.most_touched = touched;
        EXPECT_EQ(differences(crowded(), slanting, {.limits = limits, .spheres = true}, across), 0) << touched;
        EXPECT_LT(across, 128U);
    }
    limits = {};
    limits.usual_listed = limits.listed_a_disc = 0;
    EXPECT_EQ(differences(crowded(), slanting, {.limits = limits, .spheres = true}, across), 0);
    EXPECT_LT(across, 128U);
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
    Scene scene;
    scene.spheres = {{{0.0, 0.0, 200.0}, 60.0, {}, false}, {{-20.0, 30.0, 120.0}, 8.0, {}, false}};
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
    expect_the_oracles_light({trial, {.lights = 16, .sky = 1.0, .sun = Sun{slanting, 1.0}}});
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

// Spheres so large and so near each other that double knows neither points nor shadows: balls and 106 bits decide nearly all, and
// integers what they must.
Trials hard_to_light(int spheres, PictureSize size) {
    Trials trials = stress_trials(spheres, size);
    const auto add = [&](const std::string& name, const std::function<Sphere(int)>& sphere) {
        Trial trial{"hard to light: " + name, {}, size};
        for (int i = 0; i < spheres; ++i) trial.scene.spheres.push_back(sphere(i));
        trials.push_back(trial);
    };
    Random random(seed());
    const auto small = [&] { return Sphere{random.in_cube(90.0) + glm::dvec3(0.0, 0.0, 200.0), 6.0, {}, false}; };
    add("two planes", [](int i) {
        return i % 2 == 0 ? Sphere{{0.0, 0.0, 1e15 + i}, 1e15 + i - 100, {}, false}
                          : Sphere{{1e15 + i, 0.0, 100.0}, 1e15 + i - 10, {}, false};
    });
    add("a plane behind small ones", [&](int i) {
        return i % 2 == 0 ? Sphere{{0.0, 0.0, 1e15 + i}, 1e15 + i - 300, {}, false} : small();
    });
    // Seen from so far that a sphere is not much larger than what double is off.
    add("tiny ones", [](int i) {
        return Sphere{{1e-9 * (i % 40 - 20), 1e-9 * (i / 40 % 40 - 12), 100.0 + 1e-10 * (i % 7)}, 4e-10, {}, false};
    });
    Camera& camera = trials.back().scene.camera;
    camera.right *= 4e-10;
    camera.up *= 4e-10;
    return trials;
}

TEST(Light, of_hard_scenes_needs_few_integers) {
#ifdef VARIANT
    constexpr int spheres = 120;  // the slow build among them takes as long as the usual one
#else
    constexpr int spheres = 600;
#endif
    constexpr int lights = 16;
    constexpr PictureSize size{25, 25};
    for (const Trial& trial : hard_to_light(spheres, size)) {
        const Scene& scene = trial.scene;
        const DrawnSpheres drawn = drawn_spheres(scene);
        std::vector<std::int32_t> visible(25 * 25, doubtful_background);
        Resolver(scene, drawn, size).certify({0, 0, size.width, size.height}, visible);
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
        LightCounts counts;
        const std::vector<LightVector> found =
            lighting.light({0, 0, size.width, size.height}, visible, nullptr, nullptr, nullptr, &counts);
        std::cout << trial.name << ": " << counts.doubts << " doubts, " << counts.in_integers << " in integers\n";
        // Each point of each light is asked of far fewer spheres than there are, and integers of hardly any.
        EXPECT_LT(counts.doubts, 1000 * spheres) << trial.name;
        EXPECT_LT(counts.in_integers, 10 * spheres) << trial.name;
        Random random(seed());
        std::vector<glm::dvec3> directions;
        for (const DirectedLight& light : lighting.lights(0)) directions.push_back(light.direction);
        for (int i = 0; i < 3 && is_sampled(1); ++i) {
            const Pixel at{i < 1 ? 12 : random.whole(0, 24), i < 1 ? 12 : random.whole(0, 24)};
            const auto place = static_cast<std::size_t>(at.y * size.width + at.x);
            if (visible[place] < 0) continue;
            const std::vector<bool> shining = shines(scene, size, at, visible[place], directions);
            LightVector expected;
            for (std::size_t k = 0; k < shining.size(); ++k) {
                if (shining[k]) expected += lighting.lights(0)[k].share;
            }
            EXPECT_EQ(found[place], expected) << trial.name << ", " << at.x << "," << at.y;
        }
    }
}

// What this says of the oracle and of the amount of work, other flags of the compiler (flags/) say as well; and sanitizers, with
// which it takes long, find nothing that they do not find above.
#if !defined(VARIANT) && !defined(SPHEREVIEW_SANITIZED)

// A few pixels around a point that is seen.
Trial close_up(Scene scene, const glm::dvec3& point) {
    Camera& camera = scene.camera;
    camera.center = point;
    camera.right = 1e-4 * unit(cross(point, {0.0, 1.0, 0.0}));
    camera.up = 1e-4 * unit(cross(camera.right, point));
    return {"close up", scene, {21, 21}};
}

// The oracle notices where float is trusted too much: at a light in the tangent plane, and at a shadow's edge.
TEST(Light, too_little_doubt_is_noticed) {
    Random random(seed());
    LightTileLimits careless;
    careless.facing_doubt = 0.0F;
    std::size_t across = 0;
    int wrong_sides = 0;
    int wrong_shadows = 0;
    for (int i = 0; i < 10; ++i) {
        Scene scene = lit_middle();
        const glm::dvec3 normal = unit(glm::dvec3(0.0, 0.0, -1.5) + random.in_cube(1.0));
        const glm::dvec3 point = scene.spheres[0].center + scene.spheres[0].radius * normal;
        const glm::dvec3 tangent = unit(cross(normal, {0.2, 0.9, 0.1}));
        EXPECT_EQ(differences(close_up(scene, point), tangent, {}, across), 0);
        wrong_sides += differences(close_up(scene, point), tangent, {.limits = careless, .spheres = true}, across);

        const glm::dvec3 toward_light = unit(normal + 0.5 * tangent);
        const glm::dvec3 aside = unit(cross(toward_light, normal));
        scene.spheres.push_back({point + 60.0 * toward_light + 5.0 * aside, 5.0, {}, false});
        EXPECT_EQ(differences(close_up(scene, point), toward_light, {}, across), 0);
        wrong_shadows += differences(close_up(scene, point), toward_light, {.limits = {}, .spheres = false}, across);
    }
    EXPECT_GT(wrong_sides, 0);
    EXPECT_GT(wrong_shadows, 0);
}

// What is far away or huge makes float and double ask no more than it must: nearly all is decided for all points at once.
TEST(Light, work_is_bounded_whatever_is_around) {
    constexpr int others = 300;
    constexpr int lights = 16;
    constexpr PictureSize size{60, 60};
    for (const Surroundings& around : surroundings(200, others)) {
        const Scene& scene = around.scene;
        const std::vector<std::int32_t> visible = picture(scene, size);
        const DrawnSpheres drawn = drawn_spheres(scene);
        const Lighting lighting(scene, drawn, scene.camera, size, 1, {.lights = lights, .sky = 1.0, .sun = {}});
        LightCounts counts;
        lighting.light({0, 0, size.width, size.height}, visible, nullptr, nullptr, nullptr, &counts);
        EXPECT_GT(counts.points_facing, 1000) << around.name;
        EXPECT_LT(counts.doubts, 2 * lights * others) << around.name;
    }
}

// Each mistake in the definition shows in at least one of the scenes.
TEST(Light, mistakes_are_noticed) {
    const std::vector<LitTrial> trials = edges();
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

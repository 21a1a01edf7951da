// The tiles in which the light of all pixels is decided at once, with limits that are not the usual ones.
#include <gtest/gtest.h>

#include <algorithm>

#include "light/light_tiles.hpp"
#include "light/lit_points.hpp"
#include "oracle/light_oracle.hpp"
#include "oracle/light_scenes.hpp"
#include "oracle/oracle.hpp"
#include "oracle/random.hpp"
#include "scene/vectors.hpp"

namespace sphereview::oracle {

namespace {

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

// Other flags of the compiler (flags/) say the same of the oracle; and sanitizers, with which it takes long, find nothing that they
// do not find above.
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

#endif

}  // namespace

}  // namespace sphereview::oracle

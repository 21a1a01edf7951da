#include "cpu/cpu_renderer.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "base/background_job.hpp"
#include "base/parallel.hpp"
#include "exact/resolve.hpp"
#include "support/spheres.hpp"

namespace sphereview {

namespace {

using Indices = std::vector<std::int32_t>;

// What the renderer writes for a block.
Indices traced(const Scene& scene, PictureSize size, const Block& block) {
    const DrawnSpheres drawn = drawn_spheres(scene);
    Indices visible(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height), -7);
    const CandidateLists lists = build_lists(drawn, scene.camera, size, cpu_tile_costs);
    CpuRenderer(drawn, lists, scene.camera, size).trace(block, visible);
    return visible;
}

// The numbers in the scene of what the whole picture shows, doubtful pixels decided.
Indices seen(const Scene& scene, PictureSize size) {
    const Block whole{0, 0, size.width, size.height};
    Indices visible = traced(scene, size, whole);
    const DrawnSpheres drawn = drawn_spheres(scene);
    Resolver(scene, drawn, size).certify(whole, visible);
    return visible;
}

Scene scattered(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
    Scene scene;
    for (int i = 0; i < 12; ++i) {
        scene.spheres.push_back({{between(-80, 80), between(-80, 80), between(-50, 300)}, between(2, 40), {}, false});
    }
    return scene;
}

}  // namespace

TEST(CpuRenderer, SeesTheNearestHitAheadOfTheEye) {
    EXPECT_EQ(seen({}, {2, 1}), (Indices{-1, -1}));
    EXPECT_EQ(seen(scene_of({{{0, 0, 200}, 5, {}, true}}), {1, 1}), (Indices{-1}));
    EXPECT_EQ(seen(scene_of({{{0, 0, 200}, 5}, {{0, 0, 150}, 5}}), {1, 1}), (Indices{1}));
    EXPECT_EQ(seen(scene_of({{{0, 0, 150}, 5}, {{0, 0, 200}, 5}}), {1, 1}), (Indices{0}));
    // A hit counts, not a centre.
    EXPECT_EQ(seen(scene_of({{{0, 0, 150}, 5}, {{0, 0, 200}, 90}}), {1, 1}), (Indices{1}));
    // The first of equal spheres.
    EXPECT_EQ(seen(scene_of({{{0, 0, 150}, 5}, {{0, 0, 150}, 5}}), {3, 1}), (Indices{-1, 0, -1}));
    // What lies behind the eye, and the inside of a sphere around the eye.
    EXPECT_EQ(seen(scene_of({{{0, 0, -50}, 49}}), {1, 1}), (Indices{-1}));
    EXPECT_EQ(seen(scene_of({{{0, 0, -50}, 51}}), {3, 3}), Indices(9, 0));
    EXPECT_EQ(seen(scene_of({{{0, 0, 0}, 500}, {{0, 0, 150}, 5}}), {1, 1}), (Indices{1}));
    // A ray that touches.
    EXPECT_EQ(seen(scene_of({{{8, 0, 200}, 8}}), {1, 1}), (Indices{0}));
    EXPECT_EQ(seen(scene_of({{{8.0625, 0, 200}, 8}}), {1, 1}), (Indices{-1}));
}

TEST(CpuRenderer, SeesABallBetweenHiddenOnesUnderItsDrawnIndex) {
    const Scene scene = scene_of({{{0, 0, 110}, 9, {}, true}, {{0, 0, 200}, 9}, {{0, 0, 120}, 9, {}, true}, {{0, 0, 180}, 9}});
    EXPECT_EQ(traced(scene, {1, 1}, {0, 0, 1, 1}), (Indices{1}));
    EXPECT_EQ(seen(scene, {1, 1}), (Indices{3}));
}

TEST(CpuRenderer, TracesABlockAsItTracesThePicture) {
    const PictureSize size{301, 23};
    const Scene scene = scattered(3);
    const Indices whole = traced(scene, size, {0, 0, size.width, size.height});
    for (const Block block : {Block{0, 0, 1, 1}, {300, 22, 1, 1}, {5, 3, 129, 7}, {127, 0, 128, 23}, {40, 22, 261, 1}}) {
        const Indices part = traced(scene, size, block);
        for (int y = 0; y < block.height; ++y) {
            for (int x = 0; x < block.width; ++x) {
                ASSERT_EQ(part[static_cast<std::size_t>(y * block.width + x)],
                          whole[static_cast<std::size_t>((block.y + y) * size.width + block.x + x)])
                    << "at pixel " << block.x + x << "," << block.y + y;
            }
        }
    }
}

// However long one pixel takes, what is cancelled ends soon: after 4,096 spheres in double, or a cell's comparisons with one in
// integers.
TEST(Resolver, LooksWhetherToEndWithinAPixel) {
    Scene far_apart;
    for (int i = 0; i < 5000; ++i) far_apart.spheres.push_back({{0, 0, 200.0 + 10.0 * i}, 1});
    const Scene nearly_equal = scene_of({{{0, 0, 200}, 5}, {{0, 0, 200}, std::nextafter(5.0, 6.0)}});
    const std::atomic<bool> cancelled = true;
    using Expected = std::pair<const Scene*, DecisionLevel>;
    for (const auto& [scene, expected] :
         {Expected(&far_apart, DecisionLevel::in_double), {&nearly_equal, DecisionLevel::exactly}}) {
        const DrawnSpheres drawn = drawn_spheres(*scene);
        const Resolver resolver(*scene, drawn, {1, 1});
        DecisionLevel level = DecisionLevel::in_float;
        resolver.resolve({0, 0}, level);
        EXPECT_EQ(level, expected);
        cancel_loops_by(&cancelled);
        EXPECT_THROW(resolver.resolve({0, 0}, level), Cancelled);
        cancel_loops_by(nullptr);
    }
}

}  // namespace sphereview

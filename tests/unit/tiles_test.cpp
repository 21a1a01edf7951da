// The lists of the tiles: conservative, in order, bounded, the same each time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "exact/resolve.hpp"
#include "oracle/random.hpp"
#include "support/trials.hpp"
#include "tiles/build_lists.hpp"
#include "tiles/picture_parts.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {
namespace {

using oracle::Random;

constexpr TileCosts fine = {.smallest_shift = 0, .candidate = 1.0, .test = 1.0};

Sphere ball(const glm::dvec3& center, double radius) { return {center, radius, {}, false}; }

PixelRange range_of(const Sphere& sphere, PictureSize size, const Camera& camera = {}) {
    Scene scene;
    scene.camera = camera;
    scene.spheres = {sphere};
    return PixelPlanes(camera, size, 0).range(drawn_spheres(scene, camera).center_radius[0]);
}

// Whether the ray of a pixel hits the sphere, or nearly, in the textbook's doubles.
bool nearly_hit(const Sphere& sphere, const Camera& camera, PictureSize size, Pixel pixel) {
    const RayCoefficients k = ray_coefficients(size, pixel);
    const double m = size.shorter_side();
    const glm::dvec3 d =
        m * (camera.center - camera.eye) + static_cast<double>(k.across) * camera.right + static_cast<double>(k.upward) * camera.up;
    const glm::dvec3 c = sphere.center - camera.eye;
    const double a = glm::dot(d, d);
    const double b = glm::dot(c, d);
    const double discriminant = b * b - a * (glm::dot(c, c) - sphere.radius * sphere.radius);
    return discriminant >= 0.0 && b + std::sqrt(discriminant) > 0.0;
}

bool holds(const PixelRange& range, Pixel pixel) {
    return pixel.x >= range.left && pixel.x <= range.right && pixel.y >= range.top && pixel.y <= range.bottom;
}

TEST(PixelRange, IsTightAroundASphereStraightAhead) {
    // It covers 3 pixels of 11 on its axis: the planes of the pixels beside those pass it by.
    EXPECT_EQ(range_of(ball({0, 0, 100}, 10), {11, 11}), (PixelRange{4, 4, 6, 6}));
    EXPECT_EQ(range_of(ball({0, 0, 100}, 1), {11, 11}), (PixelRange{5, 5, 5, 5}));
}

TEST(PixelRange, IsEmptyForWhatNoPixelShows) {
    EXPECT_TRUE(range_of(ball({0, 0, -100}, 10), {100, 100}).empty());    // behind the eye
    EXPECT_TRUE(range_of(ball({300, 0, 100}, 10), {100, 100}).empty());   // beside the picture
    EXPECT_TRUE(range_of(ball({0, -300, 100}, 10), {100, 100}).empty());  // below it
    EXPECT_TRUE(range_of(ball({0, 0, 100}, 0.1), {100, 100}).empty());    // between the pixels' centres
    EXPECT_FALSE(range_of(ball({0, 0, 100}, 0.1), {101, 101}).empty());
}

TEST(PixelRange, HoldsASphereThatCrossesTheEyesPlane) {
    const PixelRange range = range_of(ball({20, 0, 10}, 15), {1000, 1000});
    EXPECT_NEAR(range.left, 890, 1);
    EXPECT_EQ(range.right, 999);
    EXPECT_EQ(range_of(ball({0, 0, 0}, 15), {1000, 1000}), (PixelRange{0, 0, 999, 999}));  // around the eye
}

TEST(PixelRange, IsTheWholePictureWhereNothingIsKnown) {
    EXPECT_EQ(PixelPlanes({}, {7, 5}, 0).range(glm::vec4(0.0F)), (PixelRange{0, 0, 6, 4}));
    Camera oblique;
    oblique.center = {1e6, 0, 100};
    EXPECT_EQ(range_of(ball({0, 0, 100}, 1), {7, 5}, oblique), (PixelRange{0, 0, 6, 4}));
}

Camera random_camera(Random& random) {
    Camera camera;
    const double field = std::exp(random.between(-3.0, 3.0));
    const glm::dvec3 right = glm::normalize(random.in_cube(1.0));
    const glm::dvec3 up = glm::normalize(glm::cross(right, random.in_cube(1.0)));
    camera.eye = random.in_cube(50.0);
    camera.right = field * right;
    camera.up = field * up;
    camera.center = camera.eye + glm::cross(right, up) + random.between(-1.0, 1.0) * right + random.between(-1.0, 1.0) * up;
    return camera;
}

// Near and far, small and around the eye.
Sphere random_sphere(Random& random, const glm::dvec3& eye) {
    const glm::dvec3 place = std::exp(random.between(-5.0, 5.0)) * random.in_cube(1.0);
    return ball(eye + place, glm::length(place) * std::exp(random.between(-6.0, 2.0)));
}

TEST(PixelRange, HoldsEveryPixelThatMayShowTheSphere) {
    Random random(20261);
    const PictureSize sizes[] = {{31, 17}, {64, 64}, {1, 40}, {97, 1}};
    int hits = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        SCOPED_TRACE(trial);
        const PictureSize size = sizes[trial % 4];
        const Camera camera = trial % 3 == 0 ? Camera() : random_camera(random);
        const Sphere sphere = random_sphere(random, camera.eye);
        const PixelRange range = range_of(sphere, size, camera);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (!nearly_hit(sphere, camera, size, {x, y})) continue;
                ++hits;
                ASSERT_TRUE(holds(range, {x, y})) << x << " " << y;
            }
        }
    }
    EXPECT_GT(hits, 100'000);
}

TEST(PixelRange, IsTheSameForManySpheresAtATime) {
    Random random(20262);
    for (int trial = 0; trial < 300; ++trial) {
        SCOPED_TRACE(trial);
        const PixelPlanes planes(trial == 0 ? Camera() : random_camera(random), {trial % 7 == 0 ? 1 : 97 + trial, 31}, 0);
        std::vector<glm::vec4> spheres(200);
        for (glm::vec4& s : spheres) {
            const Sphere sphere = random_sphere(random, {});
            s = {sphere.center, sphere.radius < glm::length(sphere.center) ? sphere.radius : -sphere.radius};
        }
        spheres[3].w = 0.0F;
        spheres[70] = glm::vec4(0.0F);
        std::vector<PixelRange> ranges(spheres.size());
        planes.ranges(spheres, ranges);
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const PixelRange alone = planes.range(spheres[i]);
            ASSERT_TRUE(alone.empty() ? ranges[i].empty() : ranges[i] == alone) << i;
        }
    }
}

Scene cloud(std::size_t count, double radius, std::uint64_t seed) {
    Random random(seed);
    Scene scene;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = random.between(100.0, 500.0);
        scene.spheres.push_back(
            ball({z * random.between(-0.5, 0.5), z * random.between(-0.5, 0.5), z}, radius * random.between(0.5, 2.5)));
    }
    return scene;
}

// Every list in order and without a sphere twice; and each sphere's hits no nearer than it says.
void expect_lists_in_order(const CandidateLists& lists, const DrawnSpheres& drawn) {
    for (std::size_t tile = 0; tile + 1 < lists.begins.size(); ++tile) {
        for (std::uint32_t i = lists.begins[tile]; i < lists.begins[tile + 1]; ++i) {
            const Candidate& candidate = lists.candidates[i];
            const glm::dvec4 s(drawn.center_radius[candidate.index]);
            ASSERT_LE(candidate.nearest, glm::length(glm::dvec3(s)) - s.w);
            if (i == lists.begins[tile]) continue;
            ASSERT_LE(lists.candidates[i - 1].nearest, candidate.nearest);
            ASSERT_NE(lists.candidates[i - 1].index, candidate.index);
        }
    }
}

TEST(PixelGrid, TracesThePixelsInARange) {
    for (const int step : {1, 2, 4, 8, 16}) {
        for (int count = 1; count < 40; ++count) {
            const PixelGrid grid{{count, count}, step};
            for (int first = 0; first < count; ++first) {
                for (int last = first; last < count; ++last) {
                    const PixelRange texels = grid.texels({first, first, last, last});
                    for (int texel = 0; texel < grid.size().width; ++texel) {
                        const int pixel = grid.traced_column(texel);
                        ASSERT_EQ(texel >= texels.left && texel <= texels.right, pixel >= first && pixel <= last)
                            << step << " " << count << " " << first << " " << last << " " << texel;
                    }
                    ASSERT_TRUE(texels.empty() || grid.texels(grid.pixels(texels)) == texels);
                }
            }
        }
    }
}

// Every traced pixel shows by the lists what it shows by all spheres, and nothing where no list covers it.
void expect_lists_enough(const CandidateLists& lists, const Scene& scene, const DrawnSpheres& drawn, const PixelGrid& grid,
                         int stride) {
    expect_lists_in_order(lists, drawn);
    const Resolver by_all(scene, drawn, grid.picture);
    const Resolver by_lists(scene, drawn, grid.picture, &lists);
    DecisionLevel level{};
    for (int row = 0; row < grid.size().height; row += stride) {
        for (int column = 0; column < grid.size().width; column += stride) {
            const Pixel pixel{grid.traced_column(column), grid.traced_row(row)};
            const std::int32_t expected = by_all.resolve(pixel, level);
            ASSERT_EQ(by_lists.resolve(pixel, level), expected) << pixel.x << "," << pixel.y;
            ASSERT_TRUE(expected < 0 || holds(lists.covered, pixel)) << pixel.x << "," << pixel.y;
        }
    }
}

TEST(CandidateLists, OfAGridGiveItsPixelsWhatAllSpheresGive) {
    for (const PictureSize size : {PictureSize{203, 154}, {64, 64}, {7, 130}}) {
        for (const auto& [count, radius] : {std::pair{30, 90.0}, {3000, 8.0}, {3000, 0.4}}) {
            const Scene scene = cloud(static_cast<std::size_t>(count), radius, 11);
            const DrawnSpheres drawn = drawn_spheres(scene);
            for (const int step : {1, 2, 8}) {
                const PixelGrid grid{size, step};
                const int stride = (step == 1 ? 3 : 1) * (test::is_sanitized ? 3 : 1);
                expect_lists_enough(build_lists(drawn, scene.camera, grid, fine), scene, drawn, grid, stride);
            }
        }
    }
}

TEST(CandidateLists, AreTheSameEachTime) {
    const Scene scene = cloud(20'000, 2.0, 8);
    const DrawnSpheres drawn = drawn_spheres(scene);
    const CandidateLists first = build_lists(drawn, scene.camera, {{500, 500}}, fine);
    for (int round = 0; round < 5; ++round) {
        const CandidateLists again = build_lists(drawn, scene.camera, {{500, 500}}, fine);
        ASSERT_EQ(again.begins, first.begins);
        ASSERT_TRUE(again.candidates == first.candidates && again.levels == first.levels);
    }
}

// Spheres that all cover the whole picture, and others that all lie in one tile.
TEST(CandidateLists, StayInProportionToTheSpheres) {
    for (const double radius : {0.001, 2.0, 90.0, 900.0}) {
        Scene scene;
        for (int i = 0; i < 50'000; ++i) scene.spheres.push_back(ball({0.001, 0.001, 1000.0 + i * 1e-3}, radius));
        for (const std::int64_t budget : {std::int64_t{0}, fine.shared_budget}) {
            TileCosts costs = fine;
            costs.shared_budget = budget;
            const CandidateLists lists = build_lists(drawn_spheres(scene), scene.camera, {{1000, 1000}}, costs);
            EXPECT_LE(lists.candidates.size(), std::max(16U * scene.spheres.size(), static_cast<std::size_t>(budget))) << radius;
            EXPECT_LE(lists.levels.size(), most_tile_levels);
        }
    }
}

TEST(CandidateLists, AdaptToTheSceneAndTheGrid) {
    const auto finest = [](const Scene& scene) {
        const CandidateLists lists = build_lists(drawn_spheres(scene), scene.camera, {{1000, 1000}}, fine);
        return lists.levels.back().shift;
    };
    EXPECT_GT(finest(cloud(4, 50.0, 9)), finest(cloud(100'000, 0.2, 9)));
    const CandidateLists none = build_lists({}, {}, {{10, 10}}, fine);
    EXPECT_TRUE(none.levels.empty() && none.candidates.empty());
    // A grid's leave out what lies between its rays.
    const Scene scene = cloud(20'000, 0.3, 12);
    const DrawnSpheres drawn = drawn_spheres(scene);
    const std::size_t all = build_lists(drawn, scene.camera, {{1000, 1000}}, fine).candidates.size();
    EXPECT_LT(build_lists(drawn, scene.camera, {{1000, 1000}, 8}, fine).candidates.size(), all / 4);
}

// What its texels' lists hold.
std::size_t candidates_of(const Block& block, const CandidateLists& lists, const PixelGrid& grid) {
    std::size_t count = 0;
    for (int y = block.y; y < block.y + block.height; ++y) {
        for (int x = block.x; x < block.x + block.width; ++x) {
            for (const TileLevel& level : lists.levels) {
                count += lists.at(level, grid.traced_column(x), grid.traced_row(y)).size();
            }
        }
    }
    return count;
}

// Spheres everywhere, and many more in one corner.
TEST(PictureParts, HoldEveryTexelOnceAndNoneCostsTooMuch) {
    Scene scene = cloud(2'000, 3.0, 11);
    for (int i = 0; i < 3'000; ++i) scene.spheres.push_back(ball({-40.0, 40.0, 100.0 + i * 1e-6}, 5.0));
    const DrawnSpheres drawn = drawn_spheres(scene);
    for (const PixelGrid& grid : {PixelGrid{{203, 150}, 1}, {{203, 150}, 4}, {{1, 700}, 1}, {{700, 1}, 2}}) {
        const CandidateLists lists = build_lists(drawn, scene.camera, grid.picture, fine);
        const auto [width, height] = grid.size();
        const PixelRange covered{0, height > 2 ? 1 : 0, width - 1, height - 1};
        for (const double most : {0.0, 3e4, 1e6, 1e18}) {
            std::vector<int> taken(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
            int count = 0;
            PictureParts parts(lists, grid, covered);
            for (; !parts.ended(); ++count) {
                const auto [block, cost] = parts.take(lists, most);
                ASSERT_TRUE(block.width > 0 && block.height > 0);
                for (int y = block.y; y < block.y + block.height; ++y) {
                    for (int x = block.x; x < block.x + block.width; ++x) ++taken.at(static_cast<std::size_t>(y * width + x));
                }
                const bool smallest = block.width <= PictureParts::smallest_side && block.height <= PictureParts::smallest_side;
                EXPECT_TRUE(smallest || cost <= most) << cost;
                // A coarse grid has fewer texels than its tiles have columns: which of them it meets is not counted.
                if (grid.step == 1) {
                    EXPECT_LE(0.2 * static_cast<double>(candidates_of(block, lists, grid)), cost);
                }
            }
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    ASSERT_EQ(taken[static_cast<std::size_t>(y * width + x)], y < covered.top ? 0 : 1) << x << "," << y;
                }
            }
            EXPECT_EQ(parts.cost_left(), 0.0);
            if (most == 1e18) {
                EXPECT_EQ(count, 1);
            } else if (parts.cost() > 2.0 * most) {
                EXPECT_GT(count, 1);
            }
        }
    }
    EXPECT_TRUE(PictureParts().ended());
}

TEST(CandidateLists, SuitPicturesOfAnyShape) {
    const Scene scene = cloud(1000, 5.0, 10);
    const DrawnSpheres drawn = drawn_spheres(scene);
    for (const PictureSize size : {PictureSize{1, 1}, {1, 100'000}, {300'000'000, 1}, {65'000, 3}, {20'000, 20'000}}) {
        const CandidateLists lists = build_lists(drawn, scene.camera, size, fine);
        EXPECT_LE(lists.begins.size(), 2U << 20) << size.width;
        for (const TileLevel& level : lists.levels) lists.at(level, size.width - 1, size.height - 1);
        expect_lists_in_order(lists, drawn);
    }
}

}  // namespace
}  // namespace sphereview

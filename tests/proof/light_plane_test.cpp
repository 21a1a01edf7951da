// No tile is left out that a disc touches, and none is called covered of which a point is not: whatever rounds.
#include "light/light_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "proof/trial.hpp"

namespace sphereview {

namespace {

struct PlaneTrial {
    LightPlane plane;
    PlaneDisc disc{};
};

float float_between(Random& random, double low, double high) { return static_cast<float>(between(random, low, high)); }

// Discs from a tenth of a tile to larger than the square, many of them with an edge or a middle where tiles meet.
PlaneTrial plane_trial(Random& random) {
    constexpr std::array<std::size_t, 4> sides = {8, 128, 333, 768};
    PlaneTrial trial{{sides.at(random() % sides.size()), float_between(random, 0.01, 1.8)}};
    const LightPlane& plane = trial.plane;
    const float width = plane.tile_width();
    trial.disc.radius = width * std::exp2(float_between(random, -3.0, 9.0));
    for (float* coordinate : {&trial.disc.x, &trial.disc.y}) {
        const float edge = width * std::floor(float_between(random, 0.0, static_cast<double>(plane.side()))) - plane.half();
        switch (random() % 4) {
            case 0: *coordinate = edge; break;
            case 1: *coordinate = edge - trial.disc.radius; break;
            case 2: *coordinate = edge + trial.disc.radius; break;
            default: *coordinate = float_between(random, -1.2, 1.2) * plane.half();
        }
    }
    return trial;
}

// The first coordinate of a row or column, and the last of the one before.
struct TileEdge {
    float before;
    float first;
};

TileEdge tile_edge(const LightPlane& plane, std::size_t row) {
    const float edge = static_cast<float>(row) * plane.tile_width() - plane.half();
    TileEdge found{edge - 0x1p-18F * plane.half(), edge + 0x1p-18F * plane.half()};
    for (;;) {
        const float middle = 0.5F * (found.before + found.first);
        if (middle == found.before || middle == found.first) return found;
        (plane.tile(middle) < row ? found.before : found.first) = middle;
    }
}

float first_of(const LightPlane& plane, std::size_t row) { return row == 0 ? -plane.half() : tile_edge(plane, row).first; }

float last_of(const LightPlane& plane, std::size_t row) {
    return row + 1 == plane.side() ? plane.half() : tile_edge(plane, row + 1).before;
}

double distance(const PlaneDisc& disc, float x, float y) {
    return std::hypot(static_cast<double>(x) - static_cast<double>(disc.x), static_cast<double>(y) - static_cast<double>(disc.y));
}

// Points of the disc on its edge and where rows begin and end: as far to the left and right as there are.
TEST(LightPlane, every_tile_that_a_disc_touches_is_found) {
    Random random(test_seed());
    const int trials = trial_count(2'500);
    int asked = 0;
    for (int i = 0; i < trials; ++i) {
        const PlaneTrial trial = plane_trial(random);
        const LightPlane& plane = trial.plane;
        const PlaneDisc& disc = trial.disc;
        struct Columns {
            std::size_t first = 1;
            std::size_t last = 0;
        };
        std::vector<Columns> found(plane.side());
        plane.for_each_touched(disc, [&](std::size_t row, std::size_t first, std::size_t last) { found.at(row) = {first, last}; });
        const std::size_t bottom = plane.tile(disc.y - disc.radius);
        const std::size_t rows = plane.tile(disc.y + disc.radius) - bottom + 1;
        for (int point = 0; point < 40; ++point) {
            const std::size_t row = bottom + random() % rows;
            float y = random() % 3 == 0 ? disc.y : random() % 2 == 0 ? first_of(plane, row) : last_of(plane, row);
            if (random() % 4 == 0) y = disc.y + (random() % 2 == 0 ? disc.radius : -disc.radius);
            const double up = static_cast<double>(y) - static_cast<double>(disc.y);
            const double rest = static_cast<double>(disc.radius) * disc.radius - up * up;
            if (rest < 0.0) continue;
            double across = random() % 2 == 0 ? std::sqrt(rest) : -std::sqrt(rest);
            auto x = static_cast<float>(disc.x + across);
            while (distance(disc, x, y) > disc.radius) x = static_cast<float>(disc.x + (across *= 1.0 - 0x1p-24));
            if (std::fabs(x) > plane.half() || std::fabs(y) > plane.half()) continue;
            ++asked;
            const Columns columns = found.at(plane.tile(y));
            ASSERT_TRUE(columns.first <= plane.tile(x) && plane.tile(x) <= columns.last)
                << "trial " << i << ": " << x << ", " << y << " of the disc " << disc.x << ", " << disc.y << ", " << disc.radius;
        }
    }
    EXPECT_GT(asked, trials);
}

TEST(LightPlane, every_point_of_a_tile_that_a_disc_covers_is_in_it) {
    Random random(test_seed());
    const int trials = trial_count(10'000);
    std::size_t covered = 0;
    double nearest = 1.0;  // of any such point to the disc's edge, in parts of a tile
    for (int i = 0; i < trials; ++i) {
        const PlaneTrial trial = plane_trial(random);
        const LightPlane& tiles = trial.plane;
        const PlaneDisc& around = trial.disc;
        tiles.for_each_covered(around, [&](std::size_t row, std::size_t first, std::size_t end) {
            ASSERT_LE(end, tiles.side());
            covered += end - first;
            for (const float x : {first_of(tiles, first), last_of(tiles, end - 1)}) {
                for (const float y : {first_of(tiles, row), last_of(tiles, row)}) {
                    ASSERT_LT(distance(around, x, y), around.radius) << "trial " << i;
                    nearest = std::min(nearest, (around.radius - distance(around, x, y)) / tiles.tile_width());
                }
            }
        });
    }
    std::cout << covered << " tiles are covered; the nearest corner is " << nearest << " of a tile from the edge\n";
    EXPECT_GT(covered, 100U * static_cast<std::size_t>(trials));
    EXPECT_LT(nearest, 0.05);
}

}  // namespace

}  // namespace sphereview

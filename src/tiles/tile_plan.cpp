#include "tiles/tile_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sphereview {

namespace {

constexpr int level_step = 2;              // each level's tiles are 4 x 4 of the one before
constexpr double lookups_per_pixel = 4.0;  // what finding a list costs, in tests

TilePlan plan_from(int finest, std::int64_t most_tiles, PictureSize size) {
    TilePlan plan{{finest}, most_tiles};
    while (tiles_of(size, plan.shifts.back()).count() > most_tiles && plan.shifts.size() < most_tile_levels) {
        plan.shifts.push_back(plan.shifts.back() + level_step);
    }
    return plan;
}

// What is known of one level's lists.
struct LevelSum {
    double candidates = 0.0;
    double covered = 0.0;  // pixels, as if every sphere were an ellipse that fills its range
};

// Building the lists once, and walking them once for every pixel.
double cost(const TilePlan& plan, std::span<const PixelRange> sample, double weight, PictureSize size, const TileCosts& costs) {
    std::array<LevelSum, most_tile_levels> sums{};
    for (const PixelRange& r : sample) {
        if (r.empty()) continue;
        const std::size_t level = plan.level_of(r);
        constexpr double ellipse = 0.785;
        sums[level].candidates += weight * static_cast<double>(tiles_of(r, plan.shifts[level]).count());
        sums[level].covered += weight * ellipse * (r.right - r.left + 1.0) * (r.bottom - r.top + 1.0);
    }
    const double pixels = static_cast<double>(size.width) * size.height;
    double all = costs.candidate * static_cast<double>(tiles_of(size, plan.shifts.front()).count()) * 0.1;
    for (std::size_t level = 0; level < plan.shifts.size(); ++level) {
        const LevelSum& sum = sums[level];
        if (sum.candidates == 0.0) continue;
        const double side = std::ldexp(1.0, plan.shifts[level]);
        // The pixel of a tile is covered by one of the tile's spheres with this chance; the walk ends soon after the first.
        const double chance = std::min(1.0, sum.covered / (sum.candidates * side * side));
        const double length = sum.candidates * side * side / pixels;
        const double walked = chance < 1e-6 ? length : (1.0 - std::pow(1.0 - chance, length)) / chance;
        all += costs.candidate * sum.candidates + pixels * costs.test * (walked + lookups_per_pixel);
    }
    return all;
}

}  // namespace

TilePlan plan_tiles(std::span<const PixelRange> sample, std::size_t count, PictureSize size, const TileCosts& costs) {
    // Few spheres may cover many tiles each. Many may not: what all lists hold together stays in proportion to them.
    const auto most_tiles = std::max<std::int64_t>(16, costs.shared_budget / (static_cast<std::int64_t>(count) + 1));
    const std::int64_t table_limit = std::max<std::int64_t>(1 << 20, static_cast<std::int64_t>(count));
    const double weight = static_cast<double>(count) / static_cast<double>(sample.size());
    constexpr int coarsest_first = 6;
    TilePlan best;
    double least = 0.0;
    for (int shift = costs.smallest_shift; best.shifts.empty() || shift <= coarsest_first; ++shift) {
        if (tiles_of(size, shift).count() > table_limit && shift < 29) continue;
        const TilePlan plan = plan_from(shift, most_tiles, size);
        const double total = cost(plan, sample, weight, size, costs);
        if (best.shifts.empty() || total < least) {
            best = plan;
            least = total;
        }
    }
    return best;
}

}  // namespace sphereview

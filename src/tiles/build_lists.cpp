#include "tiles/build_lists.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "base/parallel.hpp"
#include "tiles/pixel_range.hpp"
#include "tiles/tile_plan.hpp"

namespace sphereview {

namespace {

constexpr std::size_t spheres_at_once = 4096;
constexpr std::size_t tiles_at_once = 256;
constexpr double tolerance = 0x1p-21;  // of |x| + |y| + |z| + r, for the rounding to float of the input and of the result

// No hit of the sphere is nearer to the eye than this.
float nearest_distance(const glm::vec4& sphere) {
    if (sphere.w == 0.0F) return 0.0F;  // the eye is on the surface, or nothing is known
    const glm::dvec3 center(sphere);
    const double radius = std::fabs(static_cast<double>(sphere.w));
    const double all = std::fabs(center.x) + std::fabs(center.y) + std::fabs(center.z) + radius;
    return static_cast<float>(std::max(0.0, std::fabs(glm::length(center) - radius) - tolerance * all));
}

// Nearest first; of equally near ones the order does not matter, but it should be the same each time.
void sort(Candidate* begin, Candidate* end) {
    // Floats that are not negative are in the order of their bits.
    static_assert(std::endian::native == std::endian::little && sizeof(Candidate) == sizeof(std::uint64_t));
    std::sort(begin, end, [](const Candidate& a, const Candidate& b) {
        return std::bit_cast<std::uint64_t>(a) < std::bit_cast<std::uint64_t>(b);
    });
}

// All tiles of all levels, and which of them a sphere is in.
class Tiles {
public:
    Tiles(const TilePlan& plan, PictureSize size) : plan_(plan) {
        for (const int shift : plan.shifts) {
            const auto along = [=](int pixels) { return ((pixels - 1) >> shift) + 1; };
            levels_.push_back({shift, along(size.width), count_});
            count_ += static_cast<std::uint32_t>(along(size.width)) * static_cast<std::uint32_t>(along(size.height));
        }
    }

    std::uint32_t count() const { return count_; }
    const std::vector<TileLevel>& levels() const { return levels_; }

    // Calls visit(tile) for the number of each tile that the sphere is listed in.
    template <typename Visit>
    void for_each(const PixelRange& range, const Visit& visit) const {
        if (range.empty()) return;
        const TileLevel& level = levels_[plan_.level_of(range)];
        const TileRange tiles = tiles_of(range, level.shift);
        for (int y = tiles.top; y <= tiles.bottom; ++y) {
            const std::uint32_t row = level.first + static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(level.across);
            for (int x = tiles.left; x <= tiles.right; ++x) visit(row + static_cast<std::uint32_t>(x));
        }
    }

private:
    const TilePlan& plan_;
    std::vector<TileLevel> levels_;
    std::uint32_t count_ = 0;
};

}  // namespace

CandidateLists build_lists(const DrawnSpheres& spheres, const Camera& camera, PictureSize size, const TileCosts& costs) {
    CandidateLists lists;
    if (spheres.size() == 0) return lists;
    const PixelPlanes planes(camera, size);
    std::vector<PixelRange> ranges(spheres.size());
    parallel_pieces(ranges.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ranges[i] = planes.range(spheres.center_radius[i]);
    });
    const TilePlan plan = plan_tiles(ranges, size, costs);
    const Tiles tiles(plan, size);

    // A counting sort by tile. Threads fill a list in any order; sorting it by distance makes it the same each time.
    const auto places = std::make_unique<std::atomic<std::uint32_t>[]>(tiles.count());
    parallel_pieces(ranges.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            tiles.for_each(ranges[i], [&](std::uint32_t tile) { places[tile].fetch_add(1, std::memory_order_relaxed); });
        }
    });
    lists.begins.resize(std::size_t{tiles.count()} + 1);
    std::uint32_t sum = 0;
    for (std::uint32_t tile = 0; tile < tiles.count(); ++tile) {
        lists.begins[tile] = sum;
        sum += places[tile].load(std::memory_order_relaxed);
        places[tile].store(lists.begins[tile], std::memory_order_relaxed);
    }
    lists.begins[tiles.count()] = sum;
    lists.candidates.resize(sum);
    parallel_pieces(ranges.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Candidate candidate = {static_cast<std::uint32_t>(i), nearest_distance(spheres.center_radius[i])};
            tiles.for_each(ranges[i], [&](std::uint32_t tile) {
                lists.candidates[places[tile].fetch_add(1, std::memory_order_relaxed)] = candidate;
            });
        }
    });
    parallel_pieces(tiles.count(), tiles_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            sort(lists.candidates.data() + lists.begins[tile], lists.candidates.data() + lists.begins[tile + 1]);
        }
    });

    for (auto level = tiles.levels().rbegin(); level != tiles.levels().rend(); ++level) {
        const std::uint32_t end = level == tiles.levels().rbegin() ? tiles.count() : (level - 1)->first;
        if (lists.begins[end] > lists.begins[level->first]) lists.levels.push_back(*level);
    }
    return lists;
}

}  // namespace sphereview

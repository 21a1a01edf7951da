#include "tiles/build_lists.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/uninitialized.hpp"

namespace sphereview {

namespace {

constexpr std::size_t listed_at_once = 4096;

void sort(Candidate* begin, Candidate* end) {
    std::sort(begin, end, [](const Candidate& a, const Candidate& b) { return place_in_list(a) < place_in_list(b); });
}

// Some rows of one level's tiles, few enough that their lists stay in the processor's cache while they are filled.
struct Band {
    TileLevel level;
    int first_row;
    int end_row;

    std::uint32_t tile(int x, int y) const {
        return level.first + static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(level.across) +
               static_cast<std::uint32_t>(x);
    }
};

// A sphere, and the tiles of a band through which it can be seen.
struct Entry {
    Candidate candidate;
    TileRange tiles;
};

// All tiles of all levels, and which band a row of them is in.
class Bands {
public:
    Bands(const TilePlan& plan, PictureSize size) : plan_(plan) {
        for (const int shift : plan.shifts) {
            const auto along = [=](int pixels) { return ((pixels - 1) >> shift) + 1; };
            const TileLevel level{shift, along(size.width), tiles_};
            const int rows = along(size.height);
            const int rows_at_once = (rows + bands_per_level - 1) / bands_per_level;
            levels_.push_back({level, bands_.size(), rows_at_once});
            for (int row = 0; row < rows; row += rows_at_once) bands_.push_back({level, row, std::min(rows, row + rows_at_once)});
            tiles_ += static_cast<std::uint32_t>(level.across) * static_cast<std::uint32_t>(rows);
        }
    }

    std::size_t size() const { return bands_.size(); }
    const Band& operator[](std::size_t i) const { return bands_[i]; }
    std::uint32_t tile_count() const { return tiles_; }

    // Calls visit(band number, tiles) for each band that has tiles in which the sphere is listed.
    template <typename Visit>
    void for_each(const PixelRange& range, const Visit& visit) const {
        if (range.empty()) return;
        const Level& level = levels_[plan_.level_of(range)];
        const TileRange tiles = tiles_of(range, level.tiles.shift);
        for (int row = tiles.top; row <= tiles.bottom;) {
            const std::size_t band = level.first_band + static_cast<std::size_t>(row / level.rows_at_once);
            const int end = std::min(tiles.bottom + 1, bands_[band].end_row);
            visit(band, TileRange{tiles.left, row, tiles.right, end - 1});
            row = end;
        }
    }

private:
    static constexpr int bands_per_level = 64;
    struct Level {
        TileLevel tiles;
        std::size_t first_band;
        int rows_at_once;
    };

    const TilePlan& plan_;
    std::vector<Level> levels_;
    std::vector<Band> bands_;
    std::uint32_t tiles_ = 0;
};

// How many entries of a band come from one piece of the spheres; later, where those entries begin.
struct Share {
    std::size_t entries = 0;
    std::size_t candidates = 0;
};

// Fills a band's part of the lists: a counting sort by tile, then each list by distance.
void fill(const Band& band, const Entry* begin, const Entry* end, std::size_t first_candidate, CandidateLists& lists) {
    const std::uint32_t first_tile = band.tile(0, band.first_row);
    const std::uint32_t end_tile = band.tile(0, band.end_row);
    const auto for_each_tile = [&](const auto& visit) {
        for (const Entry* entry = begin; entry != end; ++entry) {
            const TileRange& tiles = entry->tiles;
            for (int y = tiles.top; y <= tiles.bottom; ++y) {
                for (int x = tiles.left; x <= tiles.right; ++x) visit(band.tile(x, y), entry->candidate);
            }
        }
    };
    std::uint32_t* const begins = lists.begins.data();
    for_each_tile([&](std::uint32_t tile, const Candidate&) { ++begins[tile]; });
    auto sum = static_cast<std::uint32_t>(first_candidate);
    for (std::uint32_t tile = first_tile; tile < end_tile; ++tile) begins[tile] = sum += begins[tile];
    // Fill each list from its end: `begins` then holds the lists' beginnings.
    for_each_tile([&](std::uint32_t tile, const Candidate& candidate) { lists.candidates[--begins[tile]] = candidate; });
    for (std::uint32_t tile = first_tile; tile < end_tile; ++tile) {
        sort(lists.candidates.data() + begins[tile], lists.candidates.data() + (tile + 1 < end_tile ? begins[tile + 1] : sum));
    }
}

// Tiles that suit some of the spheres suit all.
TilePlan plan_by_sample(const DrawnSpheres& spheres, const PixelPlanes& planes, const PixelGrid& grid, const TileCosts& costs) {
    constexpr std::size_t sample_size = 5'000;
    std::vector<PixelRange> sample;
    for (std::size_t i = 0; i < spheres.size(); i += spheres.size() / sample_size + 1) {
        sample.push_back(grid.texels(planes.range(spheres.center_radius[i])));
    }
    return plan_tiles(sample, spheres.size(), grid.size(), costs);
}

}  // namespace

// Ranges and tiles count texels of the grid; the end of the function turns them into pixels.
CandidateLists build_lists(const DrawnSpheres& spheres, const Camera& camera, const PixelGrid& grid, const TileCosts& costs,
                           std::size_t spare) {
    CandidateLists lists;
    if (spheres.size() == 0) return lists;
    const PixelPlanes planes(camera, grid.picture, spheres.scale);
    const TilePlan plan = plan_by_sample(spheres, planes, grid, costs);
    const Bands bands(plan, grid.size());

    // Put the spheres into bands of tiles first: writing straight into lists all over memory takes twice as long.
    UninitializedVector<PixelRange> ranges(spheres.size());
    const std::size_t piece = std::max(listed_at_once, ranges.size() / 64 + 1);
    const std::size_t pieces = (ranges.size() + piece - 1) / piece;
    std::vector<Share> shares(pieces * bands.size());
    std::vector<PixelRange> covered(pieces);
    parallel_pieces(ranges.size(), piece, [&](std::size_t begin, std::size_t end) {
        planes.ranges(std::span(spheres.center_radius).subspan(begin, end - begin), std::span(ranges).subspan(begin, end - begin));
        Share* const share = &shares[begin / piece * bands.size()];
        PixelRange all;
        for (std::size_t i = begin; i < end; ++i) {
            ranges[i] = grid.texels(ranges[i]);
            all = united(all, ranges[i]);
            bands.for_each(ranges[i], [&](std::size_t band, const TileRange& tiles) {
                ++share[band].entries;
                share[band].candidates += static_cast<std::size_t>(tiles.count());
            });
        }
        covered[begin / piece] = all;
    });
    for (const PixelRange& each : covered) lists.covered = united(lists.covered, each);
    std::vector<Share> begins(bands.size() + 1);  // of each band
    Share sum;
    for (std::size_t band = 0; band < bands.size(); ++band) {
        begins[band] = sum;
        for (std::size_t i = 0; i < pieces; ++i) {
            Share& share = shares[i * bands.size() + band];
            sum.candidates += share.candidates;
            sum.entries += std::exchange(share.entries, sum.entries);
        }
    }
    begins[bands.size()] = sum;
    if (sum.candidates > std::numeric_limits<std::uint32_t>::max()) {
        throw RenderError("the lists of its tiles would hold " + std::to_string(sum.candidates) + " spheres, at most 4294967295");
    }

    UninitializedVector<Entry> entries(sum.entries);
    parallel_pieces(ranges.size(), piece, [&](std::size_t begin, std::size_t end) {
        Share* const share = &shares[begin / piece * bands.size()];
        for (std::size_t i = begin; i < end; ++i) {
            const Candidate candidate = {static_cast<std::uint32_t>(i), planes.nearest_distance(spheres.center_radius[i])};
            bands.for_each(ranges[i], [&](std::size_t band, const TileRange& tiles) {
                entries[share[band].entries++] = {candidate, tiles};
            });
        }
    });
    ranges = {};

    lists.begins.assign(std::size_t{bands.tile_count()} + 1, 0);
    lists.begins.back() = static_cast<std::uint32_t>(sum.candidates);
    lists.candidates.reserve(sum.candidates + spare);
    lists.candidates.resize(sum.candidates);
    parallel_for(bands.size(), [&](std::size_t band) {
        fill(bands[band], entries.data() + begins[band].entries, entries.data() + begins[band + 1].entries, begins[band].candidates,
             lists);
    });

    for (std::size_t band = bands.size(); band-- > 0;) {
        if (begins[band].entries == begins[band + 1].entries) continue;
        if (lists.levels.empty() || !(lists.levels.back() == bands[band].level)) lists.levels.push_back(bands[band].level);
    }
    lists.most_tiles = plan.most_tiles;
    for (TileLevel& level : lists.levels) level.shift += grid.shift();
    lists.covered = grid.pixels(lists.covered);
    return lists;
}

}  // namespace sphereview

// Chooses sizes of tiles for a scene. Lists of a single size explode when some spheres are large, so tiles have levels, each four
// times as wide as the one before. Every level with spheres costs each pixel a walk, so few spheres should share one. A sample of
// the spheres and a model of the renderer's costs choose the finest size. Also the order of the spheres in a tile's list.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/candidates.hpp"
#include "scene/camera.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {

// A rectangle of tiles of one level, inclusive.
struct TileRange {
    int left = 0;
    int top = 0;
    int right = -1;
    int bottom = -1;

    std::int64_t count() const { return (std::int64_t{right} - left + 1) * (std::int64_t{bottom} - top + 1); }
};

// The tiles with a side of 2^shift pixels that a range of pixels touches.
inline TileRange tiles_of(const PixelRange& pixels, int shift) {
    return {pixels.left >> shift, pixels.top >> shift, pixels.right >> shift, pixels.bottom >> shift};
}

inline TileRange tiles_of(PictureSize size, int shift) {
    return tiles_of(PixelRange{0, 0, size.width - 1, size.height - 1}, shift);
}

// The tile sizes of a picture, the finest first, each four times the one before.
struct TilePlan {
    std::vector<int> shifts;
    std::int64_t most_tiles = 0;  // a sphere that covers more tiles goes to the next level; not from the last one

    // The level (an index into `shifts`) in which a sphere is listed.
    std::size_t level_of(const PixelRange& pixels) const {
        std::size_t level = 0;
        while (level + 1 < shifts.size() && tiles_of(pixels, shifts[level]).count() > most_tiles) ++level;
        return level;
    }
};

// A renderer's costs of tiles, by which the tiles of least cost are chosen. The picture does not depend on them.
struct TileCosts {
    int smallest_shift = 0;  // no tile's side is below 2^this pixels
    double candidate = 1.0;  // of listing one sphere in one tile
    double test = 1.0;       // of trying one candidate for one pixel
    // The lists of a scene hold about so many candidates. A sphere that covers more tiles than its equal part of the budget, and
    // more than 16, is listed in a level of larger tiles.
    std::int64_t shared_budget = 1 << 22;
};

// The plan that costs least for `count` spheres, judged by the pixel ranges of a sample of them (at least one).
TilePlan plan_tiles(std::span<const PixelRange> sample, std::size_t count, PictureSize size, const TileCosts& costs);

// The key by which lists ascend: nearest first, equally near ones by index. The bits of floats that are not negative are in the
// floats' order.
inline std::uint64_t place_in_list(const Candidate& candidate) {
    static_assert(std::endian::native == std::endian::little && sizeof(Candidate) == sizeof(std::uint64_t));
    return std::bit_cast<std::uint64_t>(candidate);
}

}  // namespace sphereview

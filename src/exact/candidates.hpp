// The lists of screen tiles: the spheres that a pixel can show. Made by tiles/build_lists.hpp. Twin: shaders/candidates.glsl.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"

namespace sphereview {

// Columns left..right and rows top..bottom of a picture, all inclusive; empty when right < left or bottom < top.
struct PixelRange {
    std::int32_t left = 0;
    std::int32_t top = 0;
    std::int32_t right = -1;
    std::int32_t bottom = -1;

    bool empty() const { return right < left || bottom < top; }
    bool operator==(const PixelRange&) const = default;
};

// The smallest range that holds both.
inline PixelRange united(const PixelRange& a, const PixelRange& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

// A sphere in the list of a tile.
struct Candidate {
    std::uint32_t index = 0;  // among the drawn spheres
    float nearest = 0.0F;  // no ray is shorter than this from where it begins to its hit, in the units of DrawnSpheres; at least 0

    bool operator==(const Candidate&) const = default;
};

// A distance beyond every hit. Twin: `never` in shaders/filter.glsl.
inline constexpr float farthest_hit = 3.0e38F;

// Fills the free places at the end of a list (tiles/edited_lists.hpp).
inline constexpr Candidate no_candidate = {0, std::numeric_limits<float>::max()};
static_assert(no_candidate.nearest > farthest_hit);

// Whether a walk along a list stops at this candidate, given the distance of the nearest sure hit, or infinity.
template <typename Real>
bool ends_walk(const Candidate& candidate, Real sure_hit) {
    return candidate.nearest > std::min(sure_hit, Real{farthest_hit});
}

// Square tiles of one size that cover the picture, row by row.
struct TileLevel {
    int shift = 0;            // a tile's side is 2^shift pixels
    int across = 0;           // tiles in a row
    std::uint32_t first = 0;  // the number of the top left one; tiles are numbered through all levels

    bool operator==(const TileLevel&) const = default;
};

inline constexpr std::size_t most_tile_levels = 8;

// A pixel can show only spheres in the lists of its tiles, one of each level, the coarsest first. In a list `nearest` never falls,
// so a walk may stop at a sphere that begins beyond a sure hit.
struct CandidateLists {
    std::vector<TileLevel> levels;               // at most most_tile_levels; none is empty
    std::vector<std::uint32_t> begins = {0, 0};  // where each tile's list begins; one more, for the end of the last
    UninitializedVector<Candidate> candidates;
    PixelRange covered;           // pixels outside show no sphere
    std::int64_t most_tiles = 0;  // spheres that cover more tiles of a level are in the next coarser one, if any

    // The list of the level's tile in which pixel (x, y) lies.
    std::span<const Candidate> at(const TileLevel& level, int x, int y) const {
        const auto across = static_cast<std::size_t>(level.across);
        const std::size_t tile =
            level.first + static_cast<std::size_t>(y >> level.shift) * across + static_cast<std::size_t>(x >> level.shift);
        return {candidates.data() + begins[tile], candidates.data() + begins[tile + 1]};
    }
};

}  // namespace sphereview

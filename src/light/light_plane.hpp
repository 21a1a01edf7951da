// The plane perpendicular to a light: a square of it around all points of a picture, cut into tiles. docs/light.md, "Lists for a
// light".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/square_root.hpp"

namespace sphereview {

// A disc in that plane.
struct PlaneDisc {
    float x;
    float y;
    float radius;
};

class LightPlane {
public:
    LightPlane() = default;
    // `side` tiles across, 4096 at most, for points no farther than `farthest` from the middle.
    LightPlane(std::size_t side, float farthest)
        : side_(side), half_(1.001F * farthest + 0x1p-20F), to_tiles_(static_cast<float>(side) / (2.0F * half_)) {}

    std::size_t side() const { return side_; }
    // Half of the square's edge.
    float half() const { return half_; }
    float tile_width() const { return 2.0F * half_ / static_cast<float>(side_); }

    // The row or column of a coordinate; outside the square, the one at the edge. Never decreases with the coordinate, despite
    // rounding, so a range of tiles misses none between.
    std::size_t tile(float coordinate) const {
        const float place = (coordinate + half_) * to_tiles_;
        if (!(place > 0.0F)) return 0;
        return std::min(place < 4096.0F ? static_cast<std::size_t>(static_cast<int>(place)) : side_, side_ - 1);
    }

    // The tile's place among all, row by row.
    std::size_t index(float x, float y) const { return tile(y) * side_ + tile(x); }

    // Calls each(row, first, last) once for each row of tiles, with a range of columns. These tiles include every tile that the
    // disc touches.
    template <typename Each>
    void for_each_touched(const PlaneDisc& disc, const Each& each) const {
        const std::size_t bottom = tile(disc.y - disc.radius);
        const std::size_t top = tile(disc.y + disc.radius);
        if (top - bottom < 2) {
            const std::size_t left = tile(disc.x - disc.radius);
            const std::size_t right = tile(disc.x + disc.radius);
            for (std::size_t row = bottom; row <= top; ++row) each(row, left, right);
            return;
        }
        const float width = tile_width();
        // A row's edges are rounded by less than this.
        const float room = 0x1p-19F * half_;
        for (std::size_t row = bottom; row <= top; ++row) {
            const float low = static_cast<float>(row) * width - half_ - room;
            const float high = static_cast<float>(row + 1) * width - half_ + room;
            const float nearest = disc.y < low ? low - disc.y : disc.y > high ? disc.y - high : 0.0F;
            const float rest = disc.radius * disc.radius - nearest * nearest;
            const float reach = 1.0001F * square_root(std::max(rest, 0.0F)) + 0x1p-10F * disc.radius;
            const float across = std::min(reach, disc.radius);
            each(row, tile(disc.x - across), tile(disc.x + across));
        }
    }

    // Calls each(row, first, end) for rows of tiles, with a range of columns. These tiles lie in the disc as a whole. Small discs
    // cover none.
    template <typename Each>
    void for_each_covered(const PlaneDisc& disc, const Each& each) const {
        const float width = tile_width();
        const float inner = 0.9999F * disc.radius - 0x1p-18F * half_;
        if (inner < 0.7F * width) return;
        const auto all = static_cast<float>(side_);
        const float first = std::max(0.0F, std::ceil((disc.y - inner + half_) * to_tiles_));
        const float last = std::min(all, std::floor((disc.y + inner + half_) * to_tiles_));
        for (float row = first; row < last; row += 1.0F) {
            const float low = row * width - half_;
            const float farthest = std::max(std::fabs(disc.y - low), std::fabs(low + width - disc.y));
            const float rest = inner * inner - farthest * farthest;
            if (!(rest > 0.0F)) continue;
            const float across = 0.9999F * square_root(rest);
            const float left = std::max(0.0F, std::ceil((disc.x - across + half_) * to_tiles_));
            const float right = std::min(all, std::floor((disc.x + across + half_) * to_tiles_));
            if (left < right) each(static_cast<std::size_t>(row), static_cast<std::size_t>(left), static_cast<std::size_t>(right));
        }
    }

private:
    std::size_t side_ = 0;
    float half_ = 1.0F;
    float to_tiles_ = 1.0F;
};

}  // namespace sphereview

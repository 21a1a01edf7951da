// Points of a picture in a tree of balls: an answer for a whole ball spares its points the question.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/drawn.hpp"
#include "light/blockers.hpp"
#include "light/hit_places.hpp"
#include "light/lit_points.hpp"

namespace sphereview {

struct PointTree {
    static constexpr std::size_t in_leaf = 16;
    static constexpr std::size_t branches = 4;

    // The points' numbers in LitPoints, ascending, so neighbours are mostly near each other.
    std::vector<std::uint32_t> points;
    // Level by level: first the balls around `in_leaf` points each, then each ball around `branches` of the level before, at last
    // one around all.
    std::vector<std::vector<HitPlace>> balls;

    bool empty() const { return balls.empty(); }
};

// The points that lists of discs alone cannot decide, one tree for each set of lights.
struct PointTrees {
    std::vector<PointTree> known;       // all known points, if float cannot hold some sphere; else empty
    std::vector<PointTree> unknown;     // the points of LitPoints::unknown
    std::vector<std::int32_t> casting;  // if there are unknown points: the numbers of all spheres that cast shadows
};

PointTrees point_trees(const DrawnSpheres& drawn, std::span<const std::uint32_t> order, std::span<const EyeSide> sides,
                       const LitPoints& points, const Blockers& blockers);

}  // namespace sphereview

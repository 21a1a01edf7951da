// Points of a picture in balls within balls: what is sure of a ball need not be asked of its points.
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

    // The points' numbers in LitPoints, in their order there: so neighbours are mostly near each other.
    std::vector<std::uint32_t> points;
    // Level by level, those around `in_leaf` points first and the one around all last. Each of the others is around `branches` of
    // the level before it.
    std::vector<std::vector<HitPlace>> balls;

    bool empty() const { return balls.empty(); }
};

// The points for which not all can be told by lists, of each set of lights.
struct PointTrees {
    std::vector<PointTree> known;       // if there are spheres that float cannot hold; else they are empty
    std::vector<PointTree> unknown;     // LitPoints::unknown
    std::vector<std::int32_t> casting;  // the numbers of all spheres that cast shadows, if there are unknown points
};

PointTrees point_trees(const DrawnSpheres& drawn, std::span<const std::uint32_t> order, std::span<const EyeSide> sides,
                       const LitPoints& points, const Blockers& blockers);

}  // namespace sphereview

#include "light/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr std::size_t balls_at_once = 1024;

// Around balls, which may be points.
template <typename Ball>
HitPlace ball_around(std::size_t begin, std::size_t end, const Ball& ball) {
    glm::dvec3 low(unbounded);
    glm::dvec3 high(-unbounded);
    for (std::size_t i = begin; i < end; ++i) {
        const HitPlace one = ball(i);
        if (!std::isfinite(one.error)) return {glm::dvec3(0.0), unbounded};
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], one.point[axis] - one.error);
            high[axis] = std::max(high[axis], one.point[axis] + one.error);
        }
    }
    const glm::dvec3 half = 0.5 * high - 0.5 * low;
    const glm::dvec3 middle = 0.5 * low + 0.5 * high;
    // Half the box's diagonal; the differences and the middle round by a few units of what they are made of.
    return {middle, 1.01 * length_of(half) + 16.0 * double_unit * (taxicab_length(low) + taxicab_length(high))};
}

template <typename Ball>
std::vector<HitPlace> balls_around(std::size_t count, std::size_t together, const Ball& ball) {
    std::vector<HitPlace> all((count + together - 1) / together);
    parallel_pieces(all.size(), balls_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            all[i] = ball_around(i * together, std::min((i + 1) * together, count), ball);
        }
    });
    return all;
}

// place(i): of the i-th of the tree's points, which it is not without.
template <typename Place>
void add_balls(PointTree& tree, const Place& place) {
    tree.balls.push_back(balls_around(tree.points.size(), PointTree::in_leaf, place));
    while (tree.balls.back().size() > 1) {
        const std::vector<HitPlace>& last = tree.balls.back();
        tree.balls.push_back(balls_around(last.size(), PointTree::branches, [&](std::size_t i) { return last[i]; }));
    }
}

}  // namespace

PointTrees point_trees(const DrawnSpheres& drawn, std::span<const std::uint32_t> order, std::span<const EyeSide> sides,
                       const LitPoints& points, const Blockers& blockers) {
    PointTrees trees;
    for (std::size_t set = 0; set + 1 < points.begins.size(); ++set) {
        const auto begin = static_cast<std::uint32_t>(points.begins.at(set));
        const auto end = static_cast<std::uint32_t>(points.begins.at(set + 1));
        const auto first = std::ranges::lower_bound(points.unknown, begin);
        const auto last = std::ranges::lower_bound(points.unknown, end);
        PointTree& unknown = trees.unknown.emplace_back();
        unknown.points.assign(first, last);
        const auto skipped = static_cast<std::size_t>(first - points.unknown.begin());
        if (first != last) add_balls(unknown, [&](std::size_t i) { return points.unknown_places[skipped + i]; });
        PointTree& known = trees.known.emplace_back();
        if (blockers.far.empty()) continue;
        auto next = first;
        for (std::uint32_t i = begin; i < end; ++i) {
            if (next != last && *next == i) {
                ++next;
            } else {
                known.points.push_back(i);
            }
        }
        if (!known.points.empty()) add_balls(known, [&](std::size_t i) { return points.place(known.points[i]); });
    }
    if (points.unknown.empty()) return trees;
    for (const std::uint32_t index : order) {
        const std::int32_t number = drawn.number(index);
        if (sides[static_cast<std::size_t>(number)] == EyeSide::outside) trees.casting.push_back(number);
    }
    return trees;
}

}  // namespace sphereview

#include "light/tree_shadows.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

constexpr std::size_t spheres_between_checks = 4096;

}  // namespace

void TreeShadows::darken(const LitScene& lit_scene, const PointTree& tree, std::span<const std::int32_t> spheres,
                         const glm::dvec3& direction, PointBits& lit, LightCounts& counts) {
    if (tree.empty()) return;
    spheres_.assign(spheres.begin(), spheres.end());
    darken({lit_scene, tree, direction, lit, counts}, tree.balls.size() - 1, 0, 0);
}

void TreeShadows::darken(const Asked& asked, std::size_t level, std::size_t ball, std::size_t first) {
    check_cancelled();
    std::size_t in_ball = PointTree::in_leaf;
    for (std::size_t i = 0; i < level; ++i) in_ball *= PointTree::branches;
    const std::size_t begin = ball * in_ball;
    const std::size_t end = std::min(begin + in_ball, asked.tree.points.size());
    const auto points = std::span(asked.tree.points).subspan(begin, end - begin);
    if (std::ranges::none_of(points, [&](std::uint32_t point) { return asked.lit.has(point); })) return;

    // The ball's own list follows that of the ball around it.
    const HitPlace& place = asked.tree.balls[level][ball];
    const std::size_t last = spheres_.size();
    const auto is_dark = [&](std::int32_t number) {
        ++asked.counts.doubts;
        const Shadow shadow = asked.lit_scene.places.sharper_shadow(place, asked.lit_scene.sphere(number), asked.direction);
        if (shadow == Shadow::unsure) spheres_.push_back(number);
        return shadow == Shadow::all;
    };
    bool dark = last_blocker_ >= 0 && is_dark(last_blocker_);
    spheres_.resize(last);
    for (std::size_t i = first; i < last && !dark; ++i) {
        const std::int32_t number = spheres_[i];
        dark = is_dark(number);
        if (dark) last_blocker_ = number;
    }
    if (dark) {
        for (const std::uint32_t point : points) asked.lit.take(point);
    } else if (spheres_.size() > last) {
        if (level == 0) {
            darken_points(asked, points, last);
        } else {
            const std::size_t balls = asked.tree.balls[level - 1].size();
            for (std::size_t i = ball * PointTree::branches; i < std::min((ball + 1) * PointTree::branches, balls); ++i) {
                darken(asked, level - 1, i, last);
            }
        }
    }
    spheres_.resize(last);
}

void TreeShadows::darken_points(const Asked& asked, std::span<const std::uint32_t> points, std::size_t first) {
    for (const std::uint32_t point : points) {
        if (!asked.lit.has(point)) continue;
        const std::int32_t own = asked.lit_scene.number(point);
        AskedPoint asked_point = asked.lit_scene.asked(point, asked.counts);
        const auto blocks = [&](std::int32_t number) {
            ++asked.counts.doubts;
            return number >= 0 && number != own && asked_point.blocked(asked.lit_scene.sphere(number), asked.direction);
        };
        bool dark = blocks(last_blocker_);
        for (std::size_t i = first; i < spheres_.size() && !dark; ++i) {
            if (i % spheres_between_checks == 0) check_cancelled();
            dark = blocks(spheres_[i]);
            if (dark) last_blocker_ = spheres_[i];
        }
        if (dark) asked.lit.take(point);
    }
}

}  // namespace sphereview

// Shadows on the points of a tree, for which lists of discs do not do: of spheres that float cannot hold, or on points of which it
// knows too little.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "light/lit_scene.hpp"
#include "light/point_tree.hpp"

namespace sphereview {

// Asks ball by ball which spheres shadow all of a ball's points, and only about the others, ball within ball and point by point.
// Reuses its memory, and remembers the last sphere that was in the way, from light to light.
class TreeShadows {
public:
    // Takes the light from those of the tree's points that have it in `lit` and lie in the shadow of one of the spheres.
    void darken(const LitScene& lit_scene, const PointTree& tree, std::span<const std::int32_t> spheres,
                const glm::dvec3& direction, PointBits& lit, LightCounts& counts);

private:
    struct Asked {
        const LitScene& lit_scene;
        const PointTree& tree;
        const glm::dvec3& direction;
        PointBits& lit;
        LightCounts& counts;
    };
    // Of the points in one ball, by the spheres of spheres_ from `first` on.
    void darken(const Asked& asked, std::size_t level, std::size_t ball, std::size_t first);
    void darken_points(const Asked& asked, std::span<const std::uint32_t> points, std::size_t first);

    std::vector<std::int32_t> spheres_;  // numbers of those of which not all is sure, ball in ball
    std::int32_t last_blocker_ = -1;     // the number of a sphere that may well keep the light from the next points, too
};

}  // namespace sphereview

// Shadows that lists of discs cannot decide: those of spheres that float cannot hold, and those on points that float knows too
// little about.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "light/lit_scene.hpp"
#include "light/point_tree.hpp"

namespace sphereview {

// Asks of each ball which spheres surely shade all of its points or none, and of the balls and points within only about the other
// spheres. Reuses its memory from light to light, and first tries the last sphere that was in the way.
class TreeShadows {
public:
    // Clears the bits in `lit` of the tree's points that lie in the shadow of one of the spheres.
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
    // Does so for one ball, with the spheres of spheres_ from `first` on.
    void darken(const Asked& asked, std::size_t level, std::size_t ball, std::size_t first);
    void darken_points(const Asked& asked, std::span<const std::uint32_t> points, std::size_t first);

    std::vector<std::int32_t> spheres_;  // numbers of the spheres left for each ball within a ball
    std::int32_t last_blocker_ = -1;     // number of the sphere that blocked last: likely to block again
};

}  // namespace sphereview

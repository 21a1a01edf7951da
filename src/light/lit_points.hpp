// The points of a picture that light may reach, as the float filter takes them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "exact/visible.hpp"
#include "light/hit_places.hpp"
#include "light/light_set.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Where a point is: its pixel in the block, row by row, and the number of the sphere that it lies on.
struct PointOrigin {
    std::int32_t place = 0;
    std::int32_t number = 0;
};

// Points relative to the middle of them all, times a power of two, so that all lie within a cube from -1 to 1. Sorted by their sets
// of lights and then by spheres, those in the order of space: neighbours are near each other, as any light sees them.
struct LitPoints {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    // The unit normal, turned to the eye; each component is off by 2^-21 at most.
    std::vector<float> normal_x;
    std::vector<float> normal_y;
    std::vector<float> normal_z;
    std::vector<PointOrigin> origins;
    // Of each set of lights, where its points begin; one more for the end.
    std::array<std::size_t, turned_sets + 1> begins{};
    // Those of which float knows too little.
    std::vector<PointOrigin> unknown;

    glm::dvec3 middle{0.0};  // relative to the eye
    int exponent = 0;        // of the power of two
    float error = 0.0F;      // how far any point is from where it is said to be, beside the rounding to float
    float farthest = 0.0F;   // from the middle

    std::size_t size() const { return x.size(); }
};

// Which set of lights a point belongs to, with so many points along the side of a pixel.
constexpr int set_of(Pixel point, int side) { return point.y % side * side + point.x % side; }

// Of a block of points whose visible spheres are known. By the spheres' numbers: `sides`, the eye's, and `ranks`, the places in the
// order of space.
LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides,
                     std::span<const std::uint32_t> ranks, const Block& block, std::span<const std::int32_t> visible, int side);

}  // namespace sphereview

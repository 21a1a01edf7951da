// The points of a picture that light may reach, in the float filter's form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "exact/visible.hpp"
#include "light/hit_places.hpp"
#include "light/light_set.hpp"
#include "light/spatial_order.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Points that lie near each other, relative to their middle and times a power of two: all lie in a cube from -1 to 1. Sorted by
// their sets of lights, then by the cells of their spheres, so that neighbours are near each other in any light's plane. 22 bytes a
// point.
struct LitPoints {
    // Normals are whole multiples of 1 / this.
    static constexpr float normal_unit = 32767.0F;

    UninitializedVector<float> x;
    UninitializedVector<float> y;
    UninitializedVector<float> z;
    // The unit normal, turned to the eye; each component is off by at most 1/65534 + 2^-21.
    UninitializedVector<std::int16_t> normal_x;
    UninitializedVector<std::int16_t> normal_y;
    UninitializedVector<std::int16_t> normal_z;
    UninitializedVector<std::int32_t> places;  // in the block, row by row
    // Where the points of each set of lights begin, and the end.
    std::array<std::size_t, turned_sets + 1> begins{};
    // The points that float knows too little about, ascending. Their normals are 0.
    std::vector<std::uint32_t> unknown;
    std::vector<HitPlace> unknown_places;  // where the unknown points are

    glm::dvec3 middle{0.0};  // relative to the eye, in the unit of HitPlaces
    int exponent = 0;        // of the power of two
    float error = 0.0F;      // bound on any point's error, apart from the rounding to float
    float farthest = 0.0F;   // from the middle

    std::size_t size() const { return places.size(); }
    bool has_none_of(std::size_t set) const { return begins.at(set) == begins.at(set + 1); }
    // A ball around all known points, and one point, in the unit of HitPlaces.
    HitPlace ball() const;
    HitPlace place(std::size_t point) const;
};

// Bound on the error of a normal's components before they are rounded to whole numbers.
inline constexpr double most_normal_error = 0x1p-22;

// A component of a unit normal in units of 1 / normal_unit.
inline std::int16_t whole_normal(double component) {
    constexpr double unit = LitPoints::normal_unit;
    // Rounds by truncating a positive number: std::floor is a function call without SSE 4.1.
    return static_cast<std::int16_t>(static_cast<int>(std::clamp(component * unit, -unit, unit) + (unit + 0.5)) -
                                     static_cast<int>(unit));
}

// The set of lights of a point, with `side` points along the side of a pixel.
constexpr int set_of(Pixel point, int side) { return point.y % side * side + point.x % side; }

// The places in a block that show a sphere, sorted by their sets of lights and then by the cells of the spheres.
UninitializedVector<std::int32_t> shown_places(const Scene& scene, const SpatialGrid& grid, const Block& block,
                                               std::span<const std::int32_t> visible, int side);

// The scale of HitPlaces at which most of the points `shown`, at least one, are in range: 0 unless they are near the limits of
// doubles.
int scale_of_most(const Scene& scene, const glm::dvec3& eye, std::span<const std::int32_t> visible,
                  std::span<const std::int32_t> shown);

// The points at the places `shown`, in their order. `sides`: the eye's, by the spheres' numbers. `rest`, if given, gets the places
// that are left out, in their order: points much nearer to the eye than the farthest, and points on spheres out of range for
// `places`. At least one point is not left out.
LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides, const Block& block,
                     std::span<const std::int32_t> visible, int side, UninitializedVector<std::int32_t> shown,
                     UninitializedVector<std::int32_t>* rest);

}  // namespace sphereview

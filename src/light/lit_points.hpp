// The points of a picture that light may reach, as the float filter takes them.
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

// Points that lie near each other, relative to the middle of them all, times a power of two, so that all lie within a cube from -1
// to 1. Sorted by their sets of lights and then by the cells that their spheres lie in: neighbours are near each other, as any
// light sees them. Small: 22 bytes for each of a million points.
struct LitPoints {
    // Normals are whole multiples of 1 / this.
    static constexpr float normal_unit = 32767.0F;

    UninitializedVector<float> x;
    UninitializedVector<float> y;
    UninitializedVector<float> z;
    // The unit normal, turned to the eye; each component is off by 1/65534 and 2^-21 at most.
    UninitializedVector<std::int16_t> normal_x;
    UninitializedVector<std::int16_t> normal_y;
    UninitializedVector<std::int16_t> normal_z;
    UninitializedVector<std::int32_t> places;  // in the block, row by row
    // Of each set of lights, where its points begin; one more for the end.
    std::array<std::size_t, turned_sets + 1> begins{};
    // Those of which float knows too little, ascending: their normals are 0.
    std::vector<std::uint32_t> unknown;
    std::vector<HitPlace> unknown_places;  // where they are, as far as that can be told

    glm::dvec3 middle{0.0};  // relative to the eye, in the unit of HitPlaces
    int exponent = 0;        // of the power of two
    float error = 0.0F;      // how far any point is from where it is said to be, beside the rounding to float
    float farthest = 0.0F;   // from the middle

    std::size_t size() const { return places.size(); }
    bool has_none_of(std::size_t set) const { return begins.at(set) == begins.at(set + 1); }
    // Where all that are known lie, in the unit of HitPlaces, and where one does.
    HitPlace ball() const;
    HitPlace place(std::size_t point) const;
};

// A normal's components may be off by so much before they are rounded to whole numbers.
inline constexpr double most_normal_error = 0x1p-22;

// A component of a unit normal as LitPoints keep it.
inline std::int16_t whole_normal(double component) {
    constexpr double unit = LitPoints::normal_unit;
    // Rounded by what is cut off of a positive number: std::floor is a call where SSE 4.1 is not sure.
    return static_cast<std::int16_t>(static_cast<int>(std::clamp(component * unit, -unit, unit) + (unit + 0.5)) -
                                     static_cast<int>(unit));
}

// Which set of lights a point belongs to, with so many points along the side of a pixel.
constexpr int set_of(Pixel point, int side) { return point.y % side * side + point.x % side; }

// The places in a block that show a sphere, sorted by their sets of lights and then by the cells of the spheres.
UninitializedVector<std::int32_t> shown_places(const Scene& scene, const SpatialGrid& grid, const Block& block,
                                               std::span<const std::int32_t> visible, int side);

// The scale of HitPlaces at which double can tell most of the points, which are not none: 0 unless they are near the limits of
// doubles.
int scale_of_most(const Scene& scene, const glm::dvec3& eye, std::span<const std::int32_t> visible,
                  std::span<const std::int32_t> shown);

// Of the places `shown`, in their order. `sides`: the eye's, by the spheres' numbers. `rest`, if it is given, gets the places that
// are left out, in their order: those that are much nearer to the eye than the farthest, and those on spheres that are out of range
// for `places`. Some are not left out.
LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides, const Block& block,
                     std::span<const std::int32_t> visible, int side, UninitializedVector<std::int32_t> shown,
                     UninitializedVector<std::int32_t>* rest);

}  // namespace sphereview

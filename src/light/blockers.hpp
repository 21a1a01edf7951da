// The spheres that may cast shadows, as the float filter takes them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "exact/drawn.hpp"
#include "light/lit_points.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// How many units of all sizes together float is off by at most, of a point and a sphere: docs/exactness.md, "Light".
inline constexpr double light_roundings = 24.0;

// In the units of LitPoints, relative to the same middle; in an order of the drawn spheres' indices. Small: 16 bytes for each of a
// million spheres. What casts no shadow, and what float cannot hold, has the radius minus infinity and reaches nowhere. Spheres
// that hold the eye, or touch it with their surface, cast no shadow.
struct Blockers {
    UninitializedVector<float> x;
    UninitializedVector<float> y;
    UninitializedVector<float> z;
    UninitializedVector<float> radius;
    std::vector<std::int32_t> far;  // numbers of those so large or far that squares leave the range of float

    // How far what float says of a sphere and any point may be off (docs/exactness.md), for its size |x| + |y| + |z| + radius.
    float doubt(float size) const { return doubt_of_all + doubt_of_size * size; }
    float doubt_of_all = 0.0F;
    float doubt_of_size = 0.0F;

    double covered = 0.0;  // how many times their discs together cover the square that all points lie in, at most

    std::size_t size() const { return x.size(); }
};

// In the given order of the drawn spheres' indices. `sides`: the eye's, by the spheres' numbers.
Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, std::span<const std::uint32_t> order,
                  std::span<const EyeSide> sides, const HitPlaces& places, const LitPoints& points);

}  // namespace sphereview

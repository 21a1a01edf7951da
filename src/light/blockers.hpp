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

// Float's error for a point and a sphere is at most so many units of all sizes together: docs/exactness.md, "Light".
inline constexpr double light_roundings = 24.0;

// In the units of LitPoints, relative to the same middle, in an order of the drawn spheres' indices; 16 bytes a sphere. Spheres
// that cast no shadow, or that float cannot hold, have the radius minus infinity. Spheres that contain or touch the eye cast no
// shadow.
struct Blockers {
    UninitializedVector<float> x;
    UninitializedVector<float> y;
    UninitializedVector<float> z;
    UninitializedVector<float> radius;
    std::vector<std::int32_t> far;  // numbers of the spheres too large or far for squares in float

    // Float's error for any point and a sphere of this size, |x| + |y| + |z| + radius (docs/exactness.md).
    float doubt(float size) const { return doubt_of_all + doubt_of_size * size; }
    float doubt_of_all = 0.0F;
    float doubt_of_size = 0.0F;

    double covered = 0.0;  // upper bound: the discs' area, in areas of the square around all points

    std::size_t size() const { return x.size(); }
};

// `order`: of the drawn spheres' indices. `sides`: the eye's, by the spheres' numbers.
Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, std::span<const std::uint32_t> order,
                  std::span<const EyeSide> sides, const HitPlaces& places, const LitPoints& points);

}  // namespace sphereview

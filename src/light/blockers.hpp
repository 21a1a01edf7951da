// The spheres that may cast shadows, as the float filter takes them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/drawn.hpp"
#include "light/lit_points.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// In the units of LitPoints, relative to the same middle. Spheres that hold the eye, or touch it with their surface, cast no
// shadow.
struct Blockers {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    std::vector<float> radius;
    std::vector<float> doubt;  // how far what float says of the sphere and any point may be off: docs/light.md
    std::vector<std::int32_t> numbers;
    std::vector<std::int32_t> far;  // numbers of those so large or far that squares leave the range of float

    double covered = 0.0;  // how many times their discs together cover the square that all points lie in, at most

    std::size_t size() const { return x.size(); }
};

// In the given order of the drawn spheres' indices.
Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, std::span<const std::uint32_t> order, const glm::dvec3& eye,
                  const LitPoints& points);

}  // namespace sphereview

#include "shade/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "exact/exact_decision.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t spheres_at_once = 4096;
constexpr double smallest_radius = 1e-300;  // its inverse is finite
constexpr double narrowest = 1.0 + 1.0 / 256.0;

// The squares must neither over- nor underflow.
double length(const glm::dvec3& v) {
    const double most = largest_of(v);
    if (most == 0.0) return 0.0;
    if (most > 1e-120 && most < 1e120) return std::sqrt(dot(v, v));
    const glm::dvec3 u = v / most;
    return most * std::sqrt(dot(u, u));
}

// A distance from the eye that would not overflow.
glm::dvec3 from_eye(const glm::dvec3& point, const glm::dvec3& eye) {
    return {shading_scale * point.x - shading_scale * eye.x, shading_scale * point.y - shading_scale * eye.y,
            shading_scale * point.z - shading_scale * eye.z};
}

}  // namespace

DepthRange depth_range(const Scene& scene, const glm::dvec3& eye) {
    constexpr double none = std::numeric_limits<double>::infinity();
    DepthRange range{none, 0.0};
    std::mutex joining;
    parallel_pieces(scene.spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        DepthRange part{none, 0.0};
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (sphere.hidden) continue;
            const double distance = length(from_eye(sphere.center, eye));
            const double radius = shading_scale * sphere.radius;
            // From outside no hit is beyond the silhouette, which is nearer than the centre.
            part.nearest = std::min(part.nearest, std::fabs(distance - radius));
            part.farthest = std::max(part.farthest, distance < radius ? distance + radius : distance);
        }
        const std::lock_guard lock(joining);
        range = {std::min(range.nearest, part.nearest), std::max(range.farthest, part.farthest)};
    });
    if (range.nearest == none) return {};
    range.farthest = std::max(range.farthest, std::min(range.nearest, 1e308) * narrowest);
    return range;
}

ShadedSphere shaded_sphere(const Sphere& sphere, const glm::dvec3& eye) {
    ShadedSphere shaded{};
    shaded.center = from_eye(sphere.center, eye);
    shaded.radius = std::max(shading_scale * sphere.radius, smallest_radius);
    shaded.inverse_radius = 1.0 / shaded.radius;
    shaded.side = eye_side(sphere, eye) == EyeSide::outside ? 1.0 : -1.0;
    return shaded;
}

}  // namespace sphereview

#include "scene/bounds.hpp"

#include <algorithm>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr std::size_t spheres_at_once = 16384;

// What nothing takes up: less than any sphere.
constexpr SceneBounds nothing{glm::dvec3(most), glm::dvec3(-most), 0.0, 0};

// By hand: min and max of glm do not become SIMD.
void include(SceneBounds& bounds, const glm::dvec3& low, const glm::dvec3& high, double radius) {
    for (int axis = 0; axis < 3; ++axis) {
        bounds.low[axis] = low[axis] < bounds.low[axis] ? low[axis] : bounds.low[axis];
        bounds.high[axis] = high[axis] > bounds.high[axis] ? high[axis] : bounds.high[axis];
    }
    bounds.largest_radius = radius > bounds.largest_radius ? radius : bounds.largest_radius;
}

}  // namespace

double SceneBounds::extent() const {
    const glm::dvec3 sides = high - low;
    return std::min(most, std::max({sides.x, sides.y, sides.z, 2.0 * largest_radius}));
}

SceneBounds bounds_of(const Scene& scene) {
    SceneBounds all = nothing;
    std::mutex mutex;
    parallel_pieces(scene.spheres.size(), spheres_at_once, [&](std::size_t begin, std::size_t end) {
        SceneBounds part = nothing;
        for (std::size_t i = begin; i < end; ++i) {
            const Sphere& sphere = scene.spheres[i];
            if (!sphere.hidden) include(part, sphere.center - sphere.radius, sphere.center + sphere.radius, sphere.radius);
            part.hidden += sphere.hidden ? 1 : 0;
        }
        const std::lock_guard lock(mutex);
        include(all, part.low, part.high, part.largest_radius);
        all.hidden += part.hidden;
    });
    if (all.largest_radius == 0.0) return {.hidden = all.hidden};
    for (int axis = 0; axis < 3; ++axis) {
        all.low[axis] = std::max(all.low[axis], -most);
        all.high[axis] = std::min(all.high[axis], most);
    }
    return all;
}

}  // namespace sphereview

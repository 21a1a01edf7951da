#include "light/blockers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double float_roundings = light_roundings * float_unit;
constexpr double most_size = 0x1p40;  // squares, and their sums, are finite

constexpr std::size_t blockers_at_once = 16384;

}  // namespace

Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, std::span<const std::uint32_t> order,
                  std::span<const EyeSide> sides, const HitPlaces& places, const LitPoints& points) {
    Blockers all;
    for (auto* field : {&all.x, &all.y, &all.z, &all.radius}) field->resize(order.size());
    const double factor = std::ldexp(1.0, -points.exponent);
    const double middle = taxicab_length(points.middle) * factor;
    const auto farthest = static_cast<double>(points.farthest);
    // What double loses of a centre is 4 units of its size and of the middle's; a thousandth covers the roundings of the sum in
    // float.
    constexpr double in_double = 16.0 * double_unit;
    all.doubt_of_size = static_cast<float>(1.001 * (float_roundings + in_double));
    all.doubt_of_all = static_cast<float>(
        1.001 * (float_roundings + 2.0 * static_cast<double>(points.error) + in_double * 2.0 * std::min(middle, most_size)));
    std::mutex joining;
    parallel_pieces(order.size(), blockers_at_once, [&](std::size_t begin, std::size_t end) {
        double covered = 0.0;
        std::vector<std::int32_t> far;
        for (std::size_t k = begin; k < end; ++k) {
            const std::int32_t number = drawn.number(order[k]);
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
            glm::dvec3 c = (places.from_eye(sphere.center) - points.middle) * factor;
            double radius = places.scaled(sphere.radius) * factor;
            const bool casts = sides[static_cast<std::size_t>(number)] == EyeSide::outside;
            const bool in_range = taxicab_length(c) + radius < most_size && middle < most_size;
            if (casts && in_range) {
                covered += std::min(1.0, (radius / farthest) * (radius / farthest));
            } else {
                if (casts) far.push_back(number);
                c = glm::dvec3(0.0);
                radius = -std::numeric_limits<double>::infinity();
            }
            all.x[k] = static_cast<float>(c.x);
            all.y[k] = static_cast<float>(c.y);
            all.z[k] = static_cast<float>(c.z);
            all.radius[k] = static_cast<float>(radius);
        }
        const std::lock_guard lock(joining);
        all.covered += covered;
        all.far.insert(all.far.end(), far.begin(), far.end());
    });
    return all;
}

}  // namespace sphereview

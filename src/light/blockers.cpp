#include "light/blockers.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/parallel.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double float_roundings = 24.0 * float_unit;
constexpr double most_size = 0x1p40;  // squares, and their sums, are finite

constexpr std::size_t blockers_at_once = 16384;

// The others keep their order. The places ascend.
template <typename T>
void erase_places(std::vector<T>& values, const std::vector<std::size_t>& places) {
    if (places.empty()) return;
    auto gap = places.begin();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (gap != places.end() && *gap == i) {
            ++gap;
        } else {
            values[kept++] = values[i];
        }
    }
    values.resize(kept);
}

}  // namespace

Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, std::span<const std::uint32_t> order, const glm::dvec3& eye,
                  const LitPoints& points) {
    Blockers all;
    for (auto* field : {&all.x, &all.y, &all.z, &all.radius, &all.doubt}) field->resize(order.size());
    all.numbers.resize(order.size());
    const double factor = std::ldexp(1.0, -points.exponent);
    const double middle = taxicab_length(points.middle) * factor;
    const auto farthest = static_cast<double>(points.farthest);
    std::vector<std::size_t> left_out;
    std::mutex joining;
    parallel_pieces(order.size(), blockers_at_once, [&](std::size_t begin, std::size_t end) {
        double covered = 0.0;
        std::vector<std::size_t> part_left_out;
        for (std::size_t k = begin; k < end; ++k) {
            const std::int32_t number = drawn.number(order[k]);
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
            const glm::dvec3 from_eye = sphere.center - eye;
            const glm::dvec3 c = (from_eye - points.middle) * factor;
            const double radius = sphere.radius * factor;
            const double size = taxicab_length(c) + radius;
            all.numbers[k] = number;
            if (drawn.side(order[k]) != EyeSide::outside || !(size < most_size && middle < most_size)) {
                part_left_out.push_back(k);
                continue;
            }
            covered += std::min(1.0, (radius / farthest) * (radius / farthest));
            const double in_double = 4.0 * double_unit * (size + 2.0 * middle);
            const double doubt = float_roundings * (1.0 + size) + 2.0 * static_cast<double>(points.error) + 4.0 * in_double;
            all.x[k] = static_cast<float>(c.x);
            all.y[k] = static_cast<float>(c.y);
            all.z[k] = static_cast<float>(c.z);
            all.radius[k] = static_cast<float>(radius);
            all.doubt[k] = static_cast<float>(1.001 * doubt);
        }
        const std::lock_guard lock(joining);
        all.covered += covered;
        left_out.insert(left_out.end(), part_left_out.begin(), part_left_out.end());
    });
    std::ranges::sort(left_out);
    for (const std::size_t k : left_out) {
        if (drawn.side(order[k]) == EyeSide::outside) all.far.push_back(all.numbers[k]);
    }
    for (auto* field : {&all.x, &all.y, &all.z, &all.radius, &all.doubt}) erase_places(*field, left_out);
    erase_places(all.numbers, left_out);
    return all;
}

}  // namespace sphereview

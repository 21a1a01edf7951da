#include "light/blockers.hpp"

#include <algorithm>
#include <cmath>

#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr double float_roundings = 24.0 * float_unit;
constexpr double most_size = 0x1p40;  // squares, and their sums, are finite

double sum_of_sizes(const glm::dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

}  // namespace

Blockers blockers(const Scene& scene, const DrawnSpheres& drawn, const glm::dvec3& eye, const LitPoints& points) {
    Blockers all;
    for (auto* field : {&all.x, &all.y, &all.z, &all.radius, &all.doubt}) field->reserve(drawn.size());
    all.numbers.reserve(drawn.size());
    const double factor = std::ldexp(1.0, -points.exponent);
    const double middle = sum_of_sizes(points.middle) * factor;
    const auto farthest = static_cast<double>(points.farthest);
    auto gap = drawn.gone.begin();
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        if (gap != drawn.gone.end() && *gap == i) {
            ++gap;
            continue;
        }
        if (drawn.side(i) != EyeSide::outside) continue;
        const std::int32_t number = drawn.number(i);
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(number)];
        const glm::dvec3 from_eye = sphere.center - eye;
        const glm::dvec3 c = (from_eye - points.middle) * factor;
        const double radius = sphere.radius * factor;
        const double size = sum_of_sizes(c) + radius;
        if (!(size < most_size && middle < most_size)) {
            all.far.push_back(number);
            continue;
        }
        all.covered += std::min(1.0, (radius / farthest) * (radius / farthest));
        const double in_double = 4.0 * double_unit * (size + 2.0 * middle);
        const double doubt = float_roundings * (1.0 + size) + 2.0 * static_cast<double>(points.error) + 4.0 * in_double;
        all.x.push_back(static_cast<float>(c.x));
        all.y.push_back(static_cast<float>(c.y));
        all.z.push_back(static_cast<float>(c.z));
        all.radius.push_back(static_cast<float>(radius));
        all.doubt.push_back(static_cast<float>(1.001 * doubt));
        all.numbers.push_back(number);
    }
    return all;
}

}  // namespace sphereview

#include "light/lit_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t origins_at_once = 8192;

// A point may be off by so much of the half side of all points' box, beyond that nothing useful is known of it.
constexpr double most_error = 0x1p-16;
// A normal's components may be off by so much before they are rounded to float.
constexpr double most_normal_error = 0x1p-22;

// A box around points.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& least, const glm::dvec3& most) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], least[axis]);
            high[axis] = std::max(high[axis], most[axis]);
        }
    }
};

// The points of all pixels that show a sphere, by sets and then by ranks: two counting sorts in one.
std::vector<PointOrigin> sorted_origins(const Block& block, std::span<const std::int32_t> visible, int side,
                                        std::span<const std::uint32_t> ranks, std::array<std::size_t, turned_sets + 1>& begins) {
    std::vector<std::uint32_t> places(ranks.size() + 1, 0);
    const auto rank = [&](std::int32_t number) { return static_cast<std::size_t>(ranks[static_cast<std::size_t>(number)]); };
    std::size_t count = 0;
    for (const std::int32_t number : visible) {
        if (number < 0) continue;
        ++places[rank(number) + 1];
        ++count;
    }
    for (std::size_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
    std::vector<PointOrigin> by_rank(count);
    for (std::size_t i = 0; i < visible.size(); ++i) {
        if (visible[i] < 0) continue;
        by_rank[places[rank(visible[i])]++] = {static_cast<std::int32_t>(i), visible[i]};
    }
    if (side == 1) {
        std::fill(begins.begin() + 1, begins.end(), count);
        return by_rank;
    }
    const auto set = [&](const PointOrigin& origin) {
        return static_cast<std::size_t>(set_of({block.x + origin.place % block.width, block.y + origin.place / block.width}, side));
    };
    for (const PointOrigin& origin : by_rank) ++begins.at(set(origin) + 1);
    for (std::size_t i = 1; i < begins.size(); ++i) begins.at(i) += begins.at(i - 1);
    std::array<std::size_t, turned_sets + 1> next = begins;
    std::vector<PointOrigin> sorted(count);
    for (const PointOrigin& origin : by_rank) sorted[next.at(set(origin))++] = origin;
    return sorted;
}

}  // namespace

LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides,
                     std::span<const std::uint32_t> ranks, const Block& block, std::span<const std::int32_t> visible, int side) {
    LitPoints points;
    const std::vector<PointOrigin> origins = sorted_origins(block, visible, side, ranks, points.begins);
    const auto pixel_of = [&](const PointOrigin& origin) {
        return Pixel{block.x + origin.place % block.width, block.y + origin.place / block.width};
    };
    const auto place_of = [&](const PointOrigin& origin) {
        const auto number = static_cast<std::size_t>(origin.number);
        return places.at(pixel_of(origin), scene.spheres[number], sides[number]);
    };

    // Where they all are.
    std::vector<HitPlace> found(origins.size());
    Box box;
    std::mutex joining;
    parallel_pieces(origins.size(), origins_at_once, [&](std::size_t begin, std::size_t end) {
        Box part;
        for (std::size_t i = begin; i < end; ++i) {
            found[i] = place_of(origins[i]);
            if (std::isfinite(found[i].error)) part.include(found[i].point, found[i].point);
        }
        const std::lock_guard lock(joining);
        box.include(part.low, part.high);
    });
    double half = 0.0;
    if (box.low.x <= box.high.x) {
        points.middle = 0.5 * box.low + 0.5 * box.high;
        half = std::max(largest_of(0.5 * box.high - 0.5 * box.low), 0x1p-24 * largest_of(points.middle));
        std::frexp(std::max(half, smallest_double_size), &points.exponent);
    }

    // The others, of which float knows too little, leave no gap.
    const auto is_known = [&](std::size_t i) {
        const Sphere& sphere = scene.spheres[static_cast<std::size_t>(origins[i].number)];
        const double of_normal =
            found[i].error +
            16.0 * double_unit * (largest_of(found[i].point) + largest_of(sphere.center - places.eye()) + sphere.radius);
        return half > 0.0 && std::ldexp(found[i].error, -points.exponent) < most_error &&
               of_normal < most_normal_error * sphere.radius;
    };
    std::vector<std::size_t> known;
    known.reserve(origins.size());
    for (std::size_t set = 0, i = 0; set < turned_sets; ++set) {
        const std::size_t end = points.begins.at(set + 1);
        points.begins.at(set) = known.size();
        for (; i < end; ++i) {
            if (is_known(i)) {
                known.push_back(i);
            } else {
                points.unknown.push_back(origins[i]);
            }
        }
    }
    points.begins.back() = known.size();

    for (auto* component : {&points.x, &points.y, &points.z, &points.normal_x, &points.normal_y, &points.normal_z}) {
        component->resize(known.size());
    }
    points.origins.resize(known.size());
    const double factor = std::ldexp(1.0, -points.exponent);
    double error = 0.0;
    double farthest = 0.0;
    parallel_pieces(known.size(), origins_at_once, [&](std::size_t begin, std::size_t end) {
        double part_error = 0.0;
        double part_farthest = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            const PointOrigin& origin = origins[known[k]];
            const HitPlace& place = found[known[k]];
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(origin.number)];
            const glm::dvec3 p = (place.point - points.middle) * factor;
            const EyeSide side_of_eye = sides[static_cast<std::size_t>(origin.number)];
            const bool outside = places.begins_outside(pixel_of(origin), sphere, side_of_eye);
            const glm::dvec3 n = (place.point - (sphere.center - places.eye())) / (outside ? sphere.radius : -sphere.radius);
            points.x[k] = static_cast<float>(p.x);
            points.y[k] = static_cast<float>(p.y);
            points.z[k] = static_cast<float>(p.z);
            points.normal_x[k] = static_cast<float>(n.x);
            points.normal_y[k] = static_cast<float>(n.y);
            points.normal_z[k] = static_cast<float>(n.z);
            points.origins[k] = origin;
            part_error = std::max(part_error, place.error * factor);
            part_farthest = std::max(part_farthest, dot(p, p));
        }
        const std::lock_guard lock(joining);
        error = std::max(error, part_error);
        farthest = std::max(farthest, part_farthest);
    });
    // The differences here round in double, which is next to nothing beside float's unit.
    points.error = static_cast<float>(1.01 * error + 0x1p-27);
    points.farthest = static_cast<float>(1.001 * square_root(farthest) + 1e-30);
    return points;
}

}  // namespace sphereview

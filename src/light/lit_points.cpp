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

constexpr std::size_t places_at_once = 8192;

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

// The places of all pixels that show a sphere, by sets and then by cells: two counting sorts.
UninitializedVector<std::int32_t> sorted_places(const Scene& scene, const SpatialGrid& grid, const Block& block,
                                                std::span<const std::int32_t> visible, int side,
                                                std::array<std::size_t, turned_sets + 1>& begins) {
    constexpr auto nowhere = static_cast<std::uint32_t>(SpatialGrid::cells);
    UninitializedVector<std::uint32_t> cells(visible.size());
    parallel_pieces(visible.size(), places_at_once, [&](std::size_t begin, std::size_t end) {
        std::int32_t number = visible_background;
        std::uint32_t cell = nowhere;
        for (std::size_t i = begin; i < end; ++i) {
            if (visible[i] != number) {
                number = visible[i];
                cell = number < 0 ? nowhere : grid.cell(scene.spheres[static_cast<std::size_t>(number)].center);
            }
            cells[i] = cell;
        }
    });
    std::vector<std::uint32_t> next(SpatialGrid::cells + 1, 0);
    std::size_t count = 0;
    for (const std::uint32_t cell : cells) {
        if (cell == nowhere) continue;
        ++next[cell + std::size_t{1}];
        ++count;
    }
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    UninitializedVector<std::int32_t> by_cell(count);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != nowhere) by_cell[next[cells[i]]++] = static_cast<std::int32_t>(i);
    }
    if (side == 1) {
        std::fill(begins.begin() + 1, begins.end(), count);
        return by_cell;
    }
    const auto set = [&](std::int32_t place) {
        return static_cast<std::size_t>(set_of({block.x + place % block.width, block.y + place / block.width}, side));
    };
    for (const std::int32_t place : by_cell) ++begins.at(set(place) + 1);
    for (std::size_t i = 1; i < begins.size(); ++i) begins.at(i) += begins.at(i - 1);
    std::array<std::size_t, turned_sets + 1> next_of_set = begins;
    UninitializedVector<std::int32_t> sorted(count);
    for (const std::int32_t place : by_cell) sorted[next_of_set.at(set(place))++] = place;
    return sorted;
}

std::int16_t whole_normal(double component) {
    constexpr double unit = LitPoints::normal_unit;
    return static_cast<std::int16_t>(std::floor(std::clamp(component * unit, -unit, unit) + 0.5));
}

}  // namespace

LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides, const SpatialGrid& grid,
                     const Block& block, std::span<const std::int32_t> visible, int side) {
    LitPoints points;
    points.places = sorted_places(scene, grid, block, visible, side, points.begins);
    const std::size_t count = points.places.size();
    const auto pixel_of = [&](std::size_t i) {
        return Pixel{block.x + points.places[i] % block.width, block.y + points.places[i] / block.width};
    };
    const auto number_of = [&](std::size_t i) {
        return static_cast<std::size_t>(visible[static_cast<std::size_t>(points.places[i])]);
    };

    // Where they all are.
    UninitializedVector<HitDistance> found(count);
    Box box;
    std::mutex joining;
    parallel_pieces(count, places_at_once, [&](std::size_t begin, std::size_t end) {
        Box part;
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t number = number_of(i);
            found[i] = places.distance(pixel_of(i), scene.spheres[number], sides[number]);
            const HitPlace place = places.at(pixel_of(i), found[i]);
            if (std::isfinite(place.error)) part.include(place.point, place.point);
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

    for (auto* component : {&points.x, &points.y, &points.z}) component->resize(count);
    for (auto* component : {&points.normal_x, &points.normal_y, &points.normal_z}) component->resize(count);
    const double factor = std::ldexp(1.0, -points.exponent);
    const auto is_known = [&](const HitPlace& place, const Sphere& sphere) {
        const double of_normal =
            place.error + 16.0 * double_unit * (largest_of(place.point) + largest_of(sphere.center - places.eye()) + sphere.radius);
        return half > 0.0 && std::ldexp(place.error, -points.exponent) < most_error &&
               of_normal < most_normal_error * sphere.radius;
    };
    double error = 0.0;
    double farthest = 0.0;
    parallel_pieces(count, places_at_once, [&](std::size_t begin, std::size_t end) {
        double part_error = 0.0;
        double part_farthest = 0.0;
        std::vector<std::uint32_t> part_unknown;
        for (std::size_t i = begin; i < end; ++i) {
            const HitPlace place = places.at(pixel_of(i), found[i]);
            const std::size_t number = number_of(i);
            const Sphere& sphere = scene.spheres[number];
            glm::dvec3 p(0.0);
            glm::dvec3 n(0.0);
            if (is_known(place, sphere)) {
                p = (place.point - points.middle) * factor;
                const bool outside = places.begins_outside(pixel_of(i), sphere, sides[number]);
                n = (place.point - (sphere.center - places.eye())) / (outside ? sphere.radius : -sphere.radius);
                part_error = std::max(part_error, place.error * factor);
                part_farthest = std::max(part_farthest, dot(p, p));
            } else {
                part_unknown.push_back(static_cast<std::uint32_t>(i));
            }
            points.x[i] = static_cast<float>(p.x);
            points.y[i] = static_cast<float>(p.y);
            points.z[i] = static_cast<float>(p.z);
            points.normal_x[i] = whole_normal(n.x);
            points.normal_y[i] = whole_normal(n.y);
            points.normal_z[i] = whole_normal(n.z);
        }
        const std::lock_guard lock(joining);
        error = std::max(error, part_error);
        farthest = std::max(farthest, part_farthest);
        points.unknown.insert(points.unknown.end(), part_unknown.begin(), part_unknown.end());
    });
    std::ranges::sort(points.unknown);
    // The differences here round in double, which is next to nothing beside float's unit.
    points.error = static_cast<float>(1.01 * error + 0x1p-27);
    points.farthest = static_cast<float>(1.001 * square_root(farthest) + 1e-30);
    return points;
}

}  // namespace sphereview

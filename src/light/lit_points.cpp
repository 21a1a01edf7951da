#include "light/lit_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr std::size_t places_at_once = 8192;

// So many points tell how large most of them are.
constexpr std::size_t most_samples = 1024;
// Points that are nearer to the eye than the farthest by more than this are left to others: what is seen of what is nearer may be
// smaller in proportion, so float would know too little of it.
constexpr double most_depth = 1024.0;
// Powers of two by which spheres may be larger or smaller than 1 without a scale of their own.
constexpr int usual_scales = 200;

// A point may be off by so much of the half side of all points' box, beyond that nothing useful is known of it.
constexpr double most_error = 0x1p-16;
constexpr double none = std::numeric_limits<double>::infinity();

// A box around points.
struct Box {
    glm::dvec3 low{none};
    glm::dvec3 high{-none};

    void include(const glm::dvec3& least, const glm::dvec3& most) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], least[axis]);
            high[axis] = std::max(high[axis], most[axis]);
        }
    }
};

// What a point may be off, if all points lie in the box.
double largest_error_in(const Box& box) {
    return box.low.x <= box.high.x ? most_error * largest_of(0.5 * box.high - 0.5 * box.low) : 0.0;
}

std::size_t set_of_place(const Block& block, std::int32_t place, int side) {
    return static_cast<std::size_t>(set_of({block.x + place % block.width, block.y + place / block.width}, side));
}

using SetBegins = std::array<std::size_t, turned_sets + 1>;

SetBegins begins_of_sets(const Block& block, std::span<const std::int32_t> shown, int side) {
    SetBegins begins{};
    if (side == 1) {
        std::fill(begins.begin() + 1, begins.end(), shown.size());
        return begins;
    }
    for (const std::int32_t place : shown) ++begins.at(set_of_place(block, place, side) + 1);
    for (std::size_t i = 1; i < begins.size(); ++i) begins.at(i) += begins.at(i - 1);
    return begins;
}

}  // namespace

// Two counting sorts.
UninitializedVector<std::int32_t> shown_places(const Scene& scene, const SpatialGrid& grid, const Block& block,
                                               std::span<const std::int32_t> visible, int side) {
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
    if (side == 1) return by_cell;
    SetBegins next_of_set = begins_of_sets(block, by_cell, side);
    UninitializedVector<std::int32_t> sorted(count);
    for (const std::int32_t place : by_cell) sorted[next_of_set.at(set_of_place(block, place, side))++] = place;
    return sorted;
}

int scale_of_most(const Scene& scene, const glm::dvec3& eye, std::span<const std::int32_t> visible,
                  std::span<const std::int32_t> shown) {
    std::vector<int> scales;
    for (std::size_t i = 0; i < shown.size(); i += shown.size() / most_samples + 1) {
        const auto number = static_cast<std::size_t>(visible[static_cast<std::size_t>(shown[i])]);
        scales.push_back(HitPlaces::scale_for(scene.spheres[number], eye));
    }
    const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
    std::ranges::nth_element(scales, middle);
    return std::abs(*middle) < usual_scales ? 0 : *middle;
}

LitPoints lit_points(const Scene& scene, const HitPlaces& places, std::span<const EyeSide> sides, const Block& block,
                     std::span<const std::int32_t> visible, int side, UninitializedVector<std::int32_t> shown,
                     UninitializedVector<std::int32_t>* rest) {
    LitPoints points;
    points.places = std::move(shown);
    const auto pixel_of = [&](std::size_t i) {
        return Pixel{block.x + points.places[i] % block.width, block.y + points.places[i] / block.width};
    };
    const auto number_of = [&](std::size_t i) {
        return static_cast<std::size_t>(visible[static_cast<std::size_t>(points.places[i])]);
    };

    const auto ray_of = [&](std::size_t i) { return places.ray(pixel_of(i)); };

    // Where they all are.
    UninitializedVector<HitDistance> found(points.size());
    Box box;
    double nearest = none;
    bool all_in_range = true;
    double largest_error = 0.0;
    std::vector<std::uint32_t> without_normal;  // double knows too little of these
    std::mutex joining;
    const auto has_normal = [&](const HitPlace& place, const Sphere& sphere) {
        const double error =
            place.error + 16.0 * double_unit *
                              (largest_of(place.point) + largest_of(places.from_eye(sphere.center)) + places.scaled(sphere.radius));
        return error < most_normal_error * places.scaled(sphere.radius);
    };
    // find(i, ray): how far the i-th is along its ray.
    const auto look = [&](const auto& find) {
        parallel_pieces(points.size(), places_at_once, [&](std::size_t begin, std::size_t end) {
            Box part;
            double part_nearest = none;
            double part_error = 0.0;
            bool in_range = true;
            std::vector<std::uint32_t> part_without;
            for (std::size_t i = begin; i < end; ++i) {
                const Sphere& sphere = scene.spheres[number_of(i)];
                const PixelRay ray = ray_of(i);
                found[i] = find(i, ray);
                const HitPlace place = places.at(ray, found[i]);
                if (!has_normal(place, sphere)) part_without.push_back(static_cast<std::uint32_t>(i));
                if (std::isfinite(place.error)) {
                    part.include(place.point, place.point);
                    part_nearest = std::min(part_nearest, largest_of(place.point));
                    part_error = std::max(part_error, place.error);
                } else {
                    in_range = in_range && places.in_range(sphere);
                }
            }
            const std::lock_guard lock(joining);
            box.include(part.low, part.high);
            nearest = std::min(nearest, part_nearest);
            largest_error = std::max(largest_error, part_error);
            all_in_range = all_in_range && in_range;
            without_normal.insert(without_normal.end(), part_without.begin(), part_without.end());
        });
    };
    const auto sharper = [&](std::size_t i) {
        const HitDistance distance = places.sharper_distance(pixel_of(i), scene.spheres[number_of(i)], sides[number_of(i)]);
        return distance.half < found[i].half ? distance : found[i];
    };
    look(
        [&](std::size_t i, const PixelRay& ray) { return places.distance(ray, scene.spheres[number_of(i)], sides[number_of(i)]); });
    if (const double most = largest_error_in(box); largest_error >= most) {
        // The box may be as wrong as its points.
        box = Box{};
        nearest = none;
        without_normal.clear();
        look([&](std::size_t i, const PixelRay& ray) { return places.at(ray, found[i]).error < most ? found[i] : sharper(i); });
    }
    parallel_pieces(without_normal.size(), places_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) found[without_normal[k]] = sharper(without_normal[k]);
    });
    for (const std::uint32_t i : without_normal) {
        const HitPlace place = places.at(ray_of(i), found[i]);
        if (!std::isfinite(place.error)) continue;
        box.include(place.point, place.point);
        nearest = std::min(nearest, largest_of(place.point));
    }
    if (rest != nullptr) {
        const double farthest = std::max(largest_of(box.low), largest_of(box.high));
        const double least = farthest < none ? farthest / most_depth : 0.0;
        if (!all_in_range || nearest < least) {
            // Move what stays to the front.
            box = Box{};
            std::size_t kept = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const HitPlace place = places.at(ray_of(i), found[i]);
                const bool known = std::isfinite(place.error);
                const bool stays = known ? largest_of(place.point) >= least : places.in_range(scene.spheres[number_of(i)]);
                if (!stays) {
                    rest->push_back(points.places[i]);
                    continue;
                }
                if (known) box.include(place.point, place.point);
                points.places[kept] = points.places[i];
                found[kept++] = found[i];
            }
            points.places.resize(kept);
        }
    }
    const std::size_t count = points.size();
    points.begins = begins_of_sets(block, points.places, side);
    double half = 0.0;
    if (box.low.x <= box.high.x) {
        points.middle = 0.5 * box.low + 0.5 * box.high;
        half = std::max(largest_of(0.5 * box.high - 0.5 * box.low), 0x1p-24 * largest_of(points.middle));
        points.exponent = exponent_of(std::max(half, smallest_double_size));
    }

    for (auto* component : {&points.x, &points.y, &points.z}) component->resize(count);
    for (auto* component : {&points.normal_x, &points.normal_y, &points.normal_z}) component->resize(count);
    const double factor = std::ldexp(1.0, -points.exponent);
    const auto is_known = [&](const HitPlace& place, const Sphere& sphere) {
        return half > 0.0 && place.error * factor < most_error && has_normal(place, sphere);
    };
    double error = 0.0;
    double farthest = 0.0;
    parallel_pieces(count, places_at_once, [&](std::size_t begin, std::size_t end) {
        double part_error = 0.0;
        double part_farthest = 0.0;
        std::vector<std::uint32_t> part_unknown;
        for (std::size_t i = begin; i < end; ++i) {
            const HitPlace place = places.at(ray_of(i), found[i]);
            const std::size_t number = number_of(i);
            const Sphere& sphere = scene.spheres[number];
            glm::dvec3 p(0.0);
            glm::dvec3 n(0.0);
            if (is_known(place, sphere)) {
                p = (place.point - points.middle) * factor;
                const bool outside = places.begins_outside(pixel_of(i), sphere, sides[number]);
                const double radius = places.scaled(sphere.radius);
                n = (place.point - places.from_eye(sphere.center)) / (outside ? radius : -radius);
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
    for (const std::uint32_t i : points.unknown) points.unknown_places.push_back(places.at(ray_of(i), found[i]));
    // The differences here round in double, which is next to nothing beside float's unit.
    points.error = static_cast<float>(1.01 * error + 0x1p-27);
    points.farthest = static_cast<float>(1.001 * square_root(farthest) + 1e-30);
    return points;
}

HitPlace LitPoints::ball() const {
    return {middle, std::ldexp(1.01 * (static_cast<double>(farthest) + static_cast<double>(error)), exponent)};
}

HitPlace LitPoints::place(std::size_t point) const {
    const glm::dvec3 from_middle(x[point], y[point], z[point]);
    // Floats round three numbers of at most 1 by less than 2^-24 together; the sum here rounds by less than 2 units.
    const double rounded = 4.0 * double_unit * (taxicab_length(middle) + std::ldexp(3.0, exponent));
    return {middle + times_two_to(from_middle, exponent),
            1.01 * (std::ldexp(static_cast<double>(error) + 0x1p-24, exponent) + rounded)};
}

}  // namespace sphereview

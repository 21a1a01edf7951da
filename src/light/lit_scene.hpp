// The data that all lights of a picture share, and counts of the work.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "light/asked_point.hpp"
#include "light/blockers.hpp"
#include "light/hit_places.hpp"
#include "light/lit_points.hpp"
#include "light/point_tree.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The amount of work. `doubts`: questions that float left open. `in_integers`: questions that 106 bits left open, too.
struct LightCounts {
    std::int64_t points_facing = 0;
    std::int64_t tests = 0;
    std::int64_t doubts = 0;
    std::int64_t in_integers = 0;

    LightCounts& operator+=(const LightCounts& other) {
        points_facing += other.points_facing;
        tests += other.tests;
        doubts += other.doubts;
        in_integers += other.in_integers;
        return *this;
    }
};

struct LitScene {
    const Scene& scene;
    const DrawnSpheres& drawn;
    std::span<const std::uint32_t> order;  // the order of the blockers: the drawn spheres' indices
    const HitPlaces& places;
    std::span<const EyeSide> sides;  // the eye's, by number
    const Block& block;
    std::span<const std::int32_t> visible;  // the numbers of the spheres that the block shows
    const LitPoints& points;
    const Blockers& blockers;
    const PointTrees& trees;

    Pixel pixel(std::size_t point) const {
        return {block.x + points.places[point] % block.width, block.y + points.places[point] / block.width};
    }
    // The number of the sphere that a point lies on.
    std::int32_t number(std::size_t point) const { return visible[static_cast<std::size_t>(points.places[point])]; }
    const Sphere& sphere(std::int32_t number) const { return scene.spheres[static_cast<std::size_t>(number)]; }
    EyeSide side(std::int32_t number) const { return sides[static_cast<std::size_t>(number)]; }
    // The point, to be asked about lights. Counts questions that need integers in `counts`.
    AskedPoint asked(std::size_t point, LightCounts& counts) const {
        const std::int32_t own = number(point);
        const auto found = std::ranges::lower_bound(points.unknown, point);
        std::optional<HitPlace> place;
        if (found != points.unknown.end() && *found == point) {
            place = points.unknown_places[static_cast<std::size_t>(found - points.unknown.begin())];
        }
        return {places, pixel(point), sphere(own), side(own), place, &counts.in_integers};
    }
};

// A bit for each point of a range, 64 in a word, the first in the lowest bit.
class PointBits {
public:
    static constexpr std::size_t in_word = 64;

    // All 0, for the points from `begin` to before `end`.
    void reset(std::size_t begin, std::size_t end) {
        begin_ = begin;
        words_.assign((end - begin + in_word - 1) / in_word, 0);
    }
    bool has(std::size_t point) const { return (words_[(point - begin_) / in_word] & bit(point)) != 0; }
    void give(std::size_t point) { words_[(point - begin_) / in_word] |= bit(point); }
    void take(std::size_t point) { words_[(point - begin_) / in_word] &= ~bit(point); }

    std::span<std::uint64_t> words() { return words_; }

private:
    std::uint64_t bit(std::size_t point) const { return std::uint64_t{1} << (point - begin_) % in_word; }

    std::size_t begin_ = 0;
    std::vector<std::uint64_t> words_;
};

}  // namespace sphereview

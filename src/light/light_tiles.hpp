// Which points of a picture one light reaches: lists of spheres for square tiles of the plane perpendicular to the light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "light/blockers.hpp"
#include "light/hit_places.hpp"
#include "light/lit_points.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// What the lights of a picture have in common.
struct LitScene {
    const Scene& scene;
    const HitPlaces& places;
    std::span<const EyeSide> sides;  // the eye's, by number
    const Block& block;
    const LitPoints& points;
    const Blockers& blockers;

    Pixel pixel(const PointOrigin& origin) const {
        return {block.x + origin.place % block.width, block.y + origin.place / block.width};
    }
    const Sphere& sphere(std::int32_t number) const { return scene.spheres[static_cast<std::size_t>(number)]; }
    EyeSide side(std::int32_t number) const { return sides[static_cast<std::size_t>(number)]; }
};

// How many questions float left open, of a point and a sphere.
struct LightCounts {
    std::int64_t points_facing = 0;
    std::int64_t tests = 0;
    std::int64_t doubts = 0;

    LightCounts& operator+=(const LightCounts& other);
};

// Decides one light after the other; it keeps its memory between them. One thread's.
class LightTiles {
public:
    // The points [begin, end) on which a light shines, ascending.
    std::span<const std::uint32_t> lit(const LitScene& lit_scene, std::size_t begin, std::size_t end, const glm::dvec3& direction);

    const LightCounts& counts() const { return counts_; }

private:
    // The directions of the plane, and to the light.
    struct Frame {
        std::array<float, 3> across;
        std::array<float, 3> upward;
        std::array<float, 3> height;
    };
    // A point that faces the light, in the plane.
    struct Facing {
        float x;
        float y;
        float height;
        std::uint32_t point;
    };
    // A sphere's disc. Small: there are as many as spheres, for each thread.
    struct Disc {
        float x;
        float y;
        float height;
        float radius;
        float doubt;
        std::int32_t number;

        // From `low` down the sphere's centre is surely higher, from `high` up surely not.
        float low() const { return height - doubt; }
        float high() const { return height + doubt; }
        // The squares of distances; -1: none is.
        float surely_in() const { return radius > doubt ? (radius - doubt) * (radius - doubt) : -1.0F; }
        float surely_out() const { return (radius + doubt) * (radius + doubt); }
        // With room for all doubts.
        float reach() const { return radius + 2.0F * doubt; }
    };

    void choose_tiles(const Blockers& blockers, float farthest);
    std::size_t tile(float coordinate) const;
    void find_facing(const LitScene& lit_scene, std::size_t begin, std::size_t end, const glm::dvec3& direction);
    void find_discs(const LitScene& lit_scene);
    void cut();
    void drop_what_is_cut();
    bool list_discs();
    void decide(const LitScene& lit_scene, const glm::dvec3& direction);
    bool is_lit(const LitScene& lit_scene, const glm::dvec3& direction, const Facing& facing);
    // Calls each(row, first, last) for the rows of tiles that a disc touches: the range in each.
    template <typename Each>
    void for_each_row(const Disc& disc, const Each& each) const;

    Frame frame_{};
    std::size_t side_ = 0;         // tiles across
    std::size_t most_side_ = 768;  // fewer, once the lists came out too long
    float half_ = 1.0F;            // of the plane's square
    float to_tiles_ = 1.0F;
    std::vector<float> lowest_;  // of each tile the lowest undecided point; infinite when there is none
    std::vector<float> coarse_;  // the lowest of 8 x 8 tiles
    std::vector<float> cut_;     // every point of the tile below this is in shadow
    std::vector<Facing> facing_;
    std::vector<Disc> discs_;
    std::vector<std::uint32_t> begins_;
    std::vector<std::uint32_t> lists_;
    std::vector<std::uint32_t> lit_;
    LightCounts counts_;
};

}  // namespace sphereview

// Decides which points of a picture one light reaches, by lists of spheres for square tiles of the plane perpendicular to the
// light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "light/light_plane.hpp"
#include "light/lit_scene.hpp"
#include "light/tree_shadows.hpp"

namespace sphereview {

// The axes of the plane perpendicular to a light, and the direction to the light; of length 1.
struct LightAxes {
    std::array<float, 3> across;
    std::array<float, 3> upward;
    std::array<float, 3> height;
};

// The doubt and the sizes of lists in LightTiles. Only tests change these.
struct LightTileLimits {
    // Bound on the error of float's product of normal and direction (docs/exactness.md).
    float facing_doubt = 0x1p-15F;
    double most_touched = 0x1p25;                     // all discs' touched tiles together; beyond, tiles get larger
    std::size_t usual_listed = std::size_t{1} << 22;  // entries of all lists, beside `listed_a_disc`; beyond, tiles get larger
    std::size_t listed_a_disc = 16;
};

// Decides one light after the other. Reuses its memory from light to light, so each thread has its own.
class LightTiles {
public:
    explicit LightTiles(const LightTileLimits& limits = {}) : limits_(limits) {}

    // A bit for each of the points that have a set of lights, 64 in a word, the first in the lowest: whether a light shines on it.
    std::span<const std::uint64_t> lit(const LitScene& lit_scene, std::size_t set, const glm::dvec3& direction);

    const LightCounts& counts() const { return counts_; }
    // Tiles along each side of the last light's square.
    std::size_t tiles_across() const { return plane_.side(); }

private:
    // The range of points that are decided.
    struct Points {
        std::size_t begin;
        std::size_t end;
    };
    // A point that faces the light, in the plane.
    struct Facing {
        float x;
        float y;
        float height;
        std::size_t point;
    };
    // A sphere's disc. Small: there are as many as spheres, for each thread.
    struct Disc {
        float x;
        float y;
        float height;
        float radius;
        float doubt;
        std::int32_t number;

        // The sphere's centre is surely higher than points below `low`, and surely not higher than points above `high`.
        float low() const { return height - doubt; }
        float high() const { return height + doubt; }
        // Squares of distances from the disc's centre within which, or beyond which, a point is surely in, or out; -1: none is in.
        float surely_in() const { return radius > doubt ? (radius - doubt) * (radius - doubt) : -1.0F; }
        float surely_out() const { return (radius + doubt) * (radius + doubt); }
        // The radius with room for all doubts.
        float reach() const { return radius + 2.0F * doubt; }
    };
    // Lights the points that float knows enough about.
    void light_known(const LitScene& lit_scene, Points points, const glm::dvec3& direction);
    void choose_tiles(const Blockers& blockers, float farthest);
    std::size_t coarse_side() const { return (plane_.side() >> coarse_shift) + 1; }
    void find_facing(const LitScene& lit_scene, Points points, const glm::dvec3& direction);
    // Calls keeps(facing) for each remaining point, and leaves out the points for which it is false.
    template <typename Keeps>
    void sift(const LitScene& lit_scene, Points points, const Keeps& keeps);
    void find_discs(const LitScene& lit_scene);
    void cut();
    void drop_what_is_cut(const LitScene& lit_scene, Points points);
    bool list_discs();
    void decide(const LitScene& lit_scene, Points points, const glm::dvec3& direction);
    // Finds the spheres too far for float that may block the light from a point. False if one blocks it from all.
    bool find_far(const LitScene& lit_scene, const glm::dvec3& direction);
    void ask_unknown(const LitScene& lit_scene, const PointTree& tree, const glm::dvec3& direction);
    bool is_lit(const LitScene& lit_scene, const Facing& facing, const glm::dvec3& direction);

    static constexpr int coarse_shift = 3;

    LightTileLimits limits_;
    LightAxes axes_{};
    LightPlane plane_{};
    std::size_t most_side_ = 768;  // tiles across; fewer, once the lists came out too long
    std::vector<float> lowest_;    // each tile's lowest undecided point; infinite when there is none
    std::vector<float> coarse_;    // the lowest of 8 x 8 tiles
    std::vector<float> cut_;       // points of the tile below this height are in shadow
    PointBits left_;               // points that face the light and are not known to be in shadow
    std::vector<Disc> discs_;
    std::size_t last_blocker_ = 0;   // a disc that surely shades a point
    std::vector<std::int32_t> far_;  // numbers of spheres, beside the discs
    TreeShadows shadows_;
    std::vector<std::uint32_t> begins_;
    UninitializedVector<std::uint32_t> lists_;
    LightCounts counts_;
};

}  // namespace sphereview

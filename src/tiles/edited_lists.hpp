// The lists of tiles while spheres are edited.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "exact/candidates.hpp"
#include "tiles/pixel_range.hpp"
#include "tiles/tile_plan.hpp"

namespace sphereview {

// A range of places in a long array.
struct Places {
    std::size_t first = 0;
    std::size_t count = 0;
};

// A sphere that is edited leaves the lists that it was built into, whose last places become free. From then on the sphere is
// loose: it is listed in a level of its own behind the others, of 32 x 32 pixels with room for 32 spheres each. No list ever
// moves or grows, and the shaders know nothing of it. So an edit costs what it touches, also among a million spheres. Lists are
// built anew when a tile has no room, or when building is as quick (LiveLists).
class EditedLists {
public:
    static constexpr int room_in_tile = 32;

    EditedLists() = default;
    // Lists that take no edits.
    explicit EditedLists(CandidateLists built) : lists_(std::move(built)) {}
    // `built`: build_lists() of the camera and grid, with spare() candidates to spare. `scale`: the drawn spheres'.
    EditedLists(CandidateLists built, const Camera& camera, const PixelGrid& grid, int scale);

    // The candidates of all loose spheres of a picture.
    static std::size_t spare(const PixelGrid& grid);

    const CandidateLists& lists() const { return lists_; }

    // Takes a listed sphere out of the lists. False when the sphere is not where it should be: the lists must be built anew.
    bool take_out(std::uint32_t index, const glm::vec4& sphere);
    // Lists a sphere that is not listed. False when a tile has no room: the lists must be built anew.
    bool put_in(std::uint32_t index, const glm::vec4& sphere);

    // Calls visit(index) for each listed sphere that may have the same values until visit returns true; returns whether it did.
    // Does not find spheres that no ray hits.
    template <typename Visit>
    bool any_like(const glm::vec4& sphere, const Visit& visit) const;

    // The places of the candidates that changed since the last call.
    std::vector<Places> take_changes();

private:
    // A level, and its tiles that list a sphere.
    struct Listing {
        TileLevel level;
        TileRange tiles;
    };
    TileRange tiles_in(const TileLevel& level, const PixelRange& texels) const;
    Listing built_listing(const PixelRange& texels) const;
    Listing loose_listing(const PixelRange& texels) const { return {loose_level_, tiles_in(loose_level_, texels)}; }
    template <typename Visit>
    static bool for_each_tile(const Listing& listing, const Visit& visit);
    Candidate* begin_of(std::size_t tile) { return lists_.candidates.data() + lists_.begins[tile]; }
    Candidate* end_of(std::size_t tile) { return lists_.candidates.data() + lists_.begins[tile + 1]; }
    void note_change(const Candidate* begin, const Candidate* end);
    // The candidates of a listing's first tile whose distance is `nearest`.
    std::span<const Candidate> as_near(const Listing& listing, float nearest) const;

    CandidateLists lists_;
    PixelPlanes planes_{Camera(), PictureSize{1, 1}, 0};
    PixelGrid grid_;
    bool editable_ = false;
    std::size_t built_levels_ = 0;
    TileLevel loose_level_;
    std::unordered_set<std::uint32_t> loose_;
    std::vector<Places> changes_;
};

template <typename Visit>
bool EditedLists::any_like(const glm::vec4& sphere, const Visit& visit) const {
    const PixelRange texels = grid_.texels(planes_.range(sphere));
    if (!editable_ || texels.empty()) return false;
    const float nearest = planes_.nearest_distance(sphere);
    const auto any_in = [&](const Listing& listing) {
        return std::ranges::any_of(as_near(listing, nearest), [&](const Candidate& candidate) { return visit(candidate.index); });
    };
    return any_in(built_listing(texels)) || (!loose_.empty() && any_in(loose_listing(texels)));
}

}  // namespace sphereview

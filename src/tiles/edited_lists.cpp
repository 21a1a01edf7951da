#include "tiles/edited_lists.hpp"

namespace sphereview {

namespace {

constexpr int loose_shift = 5;  // the loose level's tiles have sides of 32 pixels, at least

int shift_in_texels(const PixelGrid& grid) { return std::max(loose_shift - grid.shift(), 0); }

TileRange loose_tiles(const PixelGrid& grid) { return tiles_of(grid.size(), shift_in_texels(grid)); }

}  // namespace

std::size_t EditedLists::spare(const PixelGrid& grid) { return static_cast<std::size_t>(loose_tiles(grid).count()) * room_in_tile; }

EditedLists::EditedLists(CandidateLists built, const Camera& camera, const PixelGrid& grid, int scale)
    : lists_(std::move(built)), planes_(camera, grid.picture, scale), grid_(grid), built_levels_(lists_.levels.size()) {
    editable_ = built_levels_ > 0 && built_levels_ < most_tile_levels;
    const TileRange tiles = loose_tiles(grid);
    loose_level_ = {shift_in_texels(grid) + grid.shift(), tiles.right + 1, static_cast<std::uint32_t>(lists_.begins.size() - 1)};
    lists_.candidates.resize(lists_.candidates.size() + spare(grid), no_candidate);
    for (std::int64_t i = 0; i < tiles.count(); ++i) lists_.begins.push_back(lists_.begins.back() + room_in_tile);
}

TileRange EditedLists::tiles_in(const TileLevel& level, const PixelRange& texels) const {
    return tiles_of(texels, level.shift - grid_.shift());
}

// The finest level that takes the sphere. Empty levels are not in `levels`; skipping them finds the same level.
EditedLists::Listing EditedLists::built_listing(const PixelRange& texels) const {
    std::size_t level = built_levels_ - 1;  // the finest
    while (level > 0 && tiles_in(lists_.levels[level], texels).count() > lists_.most_tiles) --level;
    return {lists_.levels[level], tiles_in(lists_.levels[level], texels)};
}

// Calls visit(tile) for each tile until visit returns false; returns whether no call did.
template <typename Visit>
bool EditedLists::for_each_tile(const Listing& listing, const Visit& visit) {
    const TileRange& tiles = listing.tiles;
    for (int y = tiles.top; y <= tiles.bottom; ++y) {
        for (int x = tiles.left; x <= tiles.right; ++x) {
            const auto tile =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(listing.level.across) + static_cast<std::size_t>(x);
            if (!visit(listing.level.first + tile)) return false;
        }
    }
    return true;
}

void EditedLists::note_change(const Candidate* begin, const Candidate* end) {
    changes_.push_back({static_cast<std::size_t>(begin - lists_.candidates.data()), static_cast<std::size_t>(end - begin)});
}

bool EditedLists::take_out(std::uint32_t index, const glm::vec4& sphere) {
    if (!editable_) return false;
    const bool was_loose = loose_.erase(index) > 0;
    const PixelRange texels = grid_.texels(planes_.range(sphere));
    if (texels.empty()) return true;
    const Candidate candidate{index, planes_.nearest_distance(sphere)};
    const bool found = for_each_tile(was_loose ? loose_listing(texels) : built_listing(texels), [&](std::size_t tile) {
        Candidate* const end = end_of(tile);
        Candidate* const place = std::ranges::lower_bound(begin_of(tile), end, place_in_list(candidate), {}, place_in_list);
        if (place == end || !(*place == candidate)) return false;
        Candidate* const first_free = std::ranges::find(place, end, no_candidate);
        std::copy(place + 1, first_free, place);
        *(first_free - 1) = no_candidate;
        note_change(place, first_free);
        return true;
    });
    if (loose_.empty()) lists_.levels.resize(built_levels_);
    return found;
}

bool EditedLists::put_in(std::uint32_t index, const glm::vec4& sphere) {
    if (!editable_) return false;
    const PixelRange texels = grid_.texels(planes_.range(sphere));
    loose_.insert(index);
    if (lists_.levels.size() == built_levels_) lists_.levels.push_back(loose_level_);
    if (texels.empty()) return true;
    lists_.covered = united(lists_.covered, grid_.pixels(texels));
    const Candidate candidate{index, planes_.nearest_distance(sphere)};
    return for_each_tile(loose_listing(texels), [&](std::size_t tile) {
        Candidate* const end = end_of(tile);
        Candidate* const place = std::ranges::lower_bound(begin_of(tile), end, place_in_list(candidate), {}, place_in_list);
        Candidate* const first_free = std::ranges::find(place, end, no_candidate);
        if (first_free == end) return false;
        std::copy_backward(place, first_free, first_free + 1);
        *place = candidate;
        note_change(place, first_free + 1);
        return true;
    });
}

std::span<const Candidate> EditedLists::as_near(const Listing& listing, float nearest) const {
    const std::size_t tile = listing.level.first +
                             static_cast<std::size_t>(listing.tiles.top) * static_cast<std::size_t>(listing.level.across) +
                             static_cast<std::size_t>(listing.tiles.left);
    const std::span list = std::span(lists_.candidates).subspan(lists_.begins[tile], lists_.begins[tile + 1] - lists_.begins[tile]);
    const auto begin = std::ranges::lower_bound(list, nearest, {}, &Candidate::nearest);
    return {begin, std::ranges::upper_bound(list, nearest, {}, &Candidate::nearest)};
}

std::vector<Places> EditedLists::take_changes() { return std::exchange(changes_, {}); }

}  // namespace sphereview

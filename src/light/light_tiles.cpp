#include "light/light_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr float never = std::numeric_limits<float>::infinity();

constexpr std::size_t at_once = 256;  // points or spheres: what the loops below turn into SIMD stays in the nearest cache
constexpr std::size_t fewest_tiles = 8;
constexpr int coarse_shift = 3;
constexpr std::size_t most_asked = 16;   // tiles that a disc asks one by one whether it is needed
constexpr double most_touched = 0x1p25;  // tiles that all discs of a light touch: many huge spheres get larger tiles
constexpr std::size_t usual_listed = std::size_t{1} << 22;  // in all lists of a light, beside some for each sphere

// A facing that float computes is off by less: 5 roundings of products that sum to 1 at most, and the normal's own error.
constexpr float facing_doubt = 0x1p-20F;

using Plane = std::array<float, at_once>;

// Where some points are, seen from a light.
struct Projected {
    Plane x;
    Plane y;
    Plane height;
    Plane facing;
};

struct Axes {
    std::array<float, 3> across;
    std::array<float, 3> upward;
    std::array<float, 3> height;
};

SPHEREVIEW_FOR_EACH_SIMD void project(const float* px, const float* py, const float* pz, int count, const Axes& axes,
                                      Projected& out) {
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        out.x[at] = px[i] * axes.across[0] + py[i] * axes.across[1] + pz[i] * axes.across[2];
        out.y[at] = px[i] * axes.upward[0] + py[i] * axes.upward[1] + pz[i] * axes.upward[2];
        out.height[at] = px[i] * axes.height[0] + py[i] * axes.height[1] + pz[i] * axes.height[2];
    }
}

SPHEREVIEW_FOR_EACH_SIMD void face(const float* nx, const float* ny, const float* nz, int count, const Axes& axes, Projected& out) {
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        out.facing[at] = nx[i] * axes.height[0] + ny[i] * axes.height[1] + nz[i] * axes.height[2];
    }
}

std::array<float, 3> to_float(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Perpendicular to the axis that a unit vector is least along.
glm::dvec3 perpendicular(const glm::dvec3& l) {
    const glm::dvec3 size{std::fabs(l.x), std::fabs(l.y), std::fabs(l.z)};
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3{1.0, 0.0, 0.0}
                            : size.y <= size.z                   ? glm::dvec3{0.0, 1.0, 0.0}
                                                                 : glm::dvec3{0.0, 0.0, 1.0};
    return unit(cross(l, axis));
}

float square(float x) { return x * x; }

}  // namespace

LightCounts& LightCounts::operator+=(const LightCounts& other) {
    points_facing += other.points_facing;
    tests += other.tests;
    doubts += other.doubts;
    return *this;
}

std::span<const std::uint32_t> LightTiles::lit(const LitScene& lit_scene, std::size_t begin, std::size_t end,
                                               const glm::dvec3& direction) {
    const glm::dvec3 l = unit(direction);
    const glm::dvec3 across = perpendicular(l);
    frame_ = {to_float(across), to_float(cross(l, across)), to_float(l)};
    lit_.clear();
    do {
        choose_tiles(lit_scene.blockers, lit_scene.points.farthest);
        find_facing(lit_scene, begin, end, direction);
        check_cancelled();
        find_discs(lit_scene);
        check_cancelled();
        cut();
        drop_what_is_cut();
    } while (!list_discs());
    decide(lit_scene, direction);
    return lit_;
}

void LightTiles::choose_tiles(const Blockers& blockers, float farthest) {
    const auto root = static_cast<std::size_t>(square_root(static_cast<double>(blockers.size())));
    const double side_touched = square_root(most_touched / (blockers.covered + 1e-9));
    const auto by_discs = static_cast<std::size_t>(std::clamp(side_touched, static_cast<double>(fewest_tiles), 768.0));
    side_ = std::min({std::clamp<std::size_t>(root, 128, 768), by_discs, most_side_});
    half_ = 1.001F * farthest + 0x1p-20F;
    to_tiles_ = static_cast<float>(side_) / (2.0F * half_);
    const std::size_t coarse_side = (side_ >> coarse_shift) + 1;
    lowest_.assign(side_ * side_, never);
    coarse_.assign(coarse_side * coarse_side, never);
    cut_.assign(side_ * side_, -never);
}

// Never decreases with the coordinate, whatever rounds: so ranges from one to another miss no tile between.
std::size_t LightTiles::tile(float coordinate) const {
    const float place = (coordinate + half_) * to_tiles_;
    if (!(place > 0.0F)) return 0;
    return std::min(place < 4096.0F ? static_cast<std::size_t>(static_cast<int>(place)) : side_, side_ - 1);
}

// Which points face the light, and the lowest of them in each tile.
void LightTiles::find_facing(const LitScene& lit_scene, std::size_t begin, std::size_t end, const glm::dvec3& direction) {
    const LitPoints& points = lit_scene.points;
    const Axes axes{frame_.across, frame_.upward, frame_.height};
    Projected projected;
    facing_.resize(end - begin);
    std::size_t count_facing = 0;
    for (std::size_t from = begin; from < end; from += at_once) {
        const auto count = static_cast<int>(std::min(at_once, end - from));
        project(&points.x[from], &points.y[from], &points.z[from], count, axes, projected);
        face(&points.normal_x[from], &points.normal_y[from], &points.normal_z[from], count, axes, projected);
        for (int i = 0; i < count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const std::size_t point = from + at;
            if (std::fabs(projected.facing[at]) <= facing_doubt) {
                const PointOrigin& origin = points.origins[point];
                ++counts_.doubts;
                if (!lit_scene.places.faces(lit_scene.pixel(origin), lit_scene.sphere(origin.number), lit_scene.side(origin.number),
                                            direction)) {
                    continue;
                }
            } else if (projected.facing[at] < 0.0F) {
                continue;
            }
            facing_[count_facing++] = {projected.x[at], projected.y[at], projected.height[at], static_cast<std::uint32_t>(point)};
        }
    }
    facing_.resize(count_facing);
    counts_.points_facing += static_cast<std::int64_t>(count_facing);
    for (const Facing& facing : facing_) {
        float& lowest = lowest_[tile(facing.y) * side_ + tile(facing.x)];
        lowest = std::min(lowest, facing.height);
    }
    const std::size_t coarse_side = (side_ >> coarse_shift) + 1;
    for (std::size_t y = 0; y < side_; ++y) {
        for (std::size_t x = 0; x < side_; ++x) {
            float& lowest = coarse_[(y >> coarse_shift) * coarse_side + (x >> coarse_shift)];
            lowest = std::min(lowest, lowest_[y * side_ + x]);
        }
    }
}

// The discs that may lie above a point of the tiles that they touch.
void LightTiles::find_discs(const LitScene& lit_scene) {
    const Blockers& blockers = lit_scene.blockers;
    const Axes axes{frame_.across, frame_.upward, frame_.height};
    const std::size_t coarse_side = (side_ >> coarse_shift) + 1;
    Projected projected;
    discs_.clear();
    for (std::size_t from = 0; from < blockers.size(); from += at_once) {
        const auto count = static_cast<int>(std::min(at_once, blockers.size() - from));
        project(&blockers.x[from], &blockers.y[from], &blockers.z[from], count, axes, projected);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const float radius = blockers.radius[from + i];
            const float doubt = blockers.doubt[from + i];
            const float reach = radius + 2.0F * doubt;
            const float x = projected.x[i];
            const float y = projected.y[i];
            if (std::fabs(x) - reach > half_ || std::fabs(y) - reach > half_) continue;
            const float high = projected.height[i] + doubt;
            const std::size_t left = tile(x - reach);
            const std::size_t right = tile(x + reach);
            const std::size_t bottom = tile(y - reach);
            const std::size_t top = tile(y + reach);
            // A large disc asks of 8 x 8 tiles at once.
            const bool large = (right - left + 1) * (top - bottom + 1) > most_asked;
            const float* all_lowest = large ? coarse_.data() : lowest_.data();
            const std::size_t side = large ? coarse_side : side_;
            const int shift = large ? coarse_shift : 0;
            bool needed = false;
            for (std::size_t row = bottom >> shift; row <= top >> shift && !needed; ++row) {
                const float* lowest = all_lowest + row * side;
                for (std::size_t column = left >> shift; column <= right >> shift; ++column) needed |= lowest[column] < high;
            }
            if (!needed) continue;
            discs_.push_back({x, y, projected.height[i], radius, doubt, blockers.numbers[from + i]});
        }
    }
}

template <typename Each>
void LightTiles::for_each_row(const Disc& disc, const Each& each) const {
    const float disc_reach = disc.reach();
    const std::size_t bottom = tile(disc.y - disc_reach);
    const std::size_t top = tile(disc.y + disc_reach);
    if (top - bottom < 2) {
        const std::size_t left = tile(disc.x - disc_reach);
        const std::size_t right = tile(disc.x + disc_reach);
        for (std::size_t row = bottom; row <= top; ++row) each(row, left, right);
        return;
    }
    const float width = 2.0F * half_ / static_cast<float>(side_);
    // A row's edges may round by less than this.
    const float room = 0x1p-19F * half_;
    for (std::size_t row = bottom; row <= top; ++row) {
        const float low = static_cast<float>(row) * width - half_ - room;
        const float high = static_cast<float>(row + 1) * width - half_ + room;
        const float nearest = disc.y < low ? low - disc.y : disc.y > high ? disc.y - high : 0.0F;
        const float rest = square(disc_reach) - square(nearest);
        const float reach = 1.0001F * square_root(std::max(rest, 0.0F)) + 0x1p-10F * disc_reach;
        const float across = std::min(reach, disc_reach);
        each(row, tile(disc.x - across), tile(disc.x + across));
    }
}

// A disc that surely covers a whole tile decides every point of the tile below it.
void LightTiles::cut() {
    const float width = 2.0F * half_ / static_cast<float>(side_);
    for (const Disc& disc : discs_) {
        const float inner = disc.surely_in() > 0.0F ? square_root(disc.surely_in()) * 0.9999F - 0x1p-18F * half_ : 0.0F;
        if (inner < 0.7F * width) continue;
        const float first = std::max(0.0F, std::ceil((disc.y - inner + half_) * to_tiles_));
        const float last = std::min(static_cast<float>(side_), std::floor((disc.y + inner + half_) * to_tiles_));
        for (float row = first; row < last; row += 1.0F) {
            const float low = row * width - half_;
            const float farthest = std::max(std::fabs(disc.y - low), std::fabs(low + width - disc.y));
            const float rest = square(inner) - square(farthest);
            if (!(rest > 0.0F)) continue;
            const float across = square_root(rest) * 0.9999F;
            const float left = std::max(0.0F, std::ceil((disc.x - across + half_) * to_tiles_));
            const float right = std::min(static_cast<float>(side_), std::floor((disc.x + across + half_) * to_tiles_));
            float* cuts = &cut_[static_cast<std::size_t>(row) * side_];
            for (float column = left; column < right; column += 1.0F) {
                float& cut = cuts[static_cast<std::size_t>(column)];
                cut = std::max(cut, disc.low());
            }
        }
    }
}

// The points that a cut leaves undecided, and the lowest of them in each tile.
void LightTiles::drop_what_is_cut() {
    std::ranges::fill(lowest_, never);
    std::size_t kept = 0;
    for (const Facing& facing : facing_) {
        const std::size_t at = tile(facing.y) * side_ + tile(facing.x);
        if (facing.height < cut_[at]) continue;
        lowest_[at] = std::min(lowest_[at], facing.height);
        facing_[kept++] = facing;
    }
    facing_.resize(kept);
}

// Lists the discs of each tile that may lie above its lowest undecided point, the highest first. Returns false when the lists would
// be too long: the next attempt has fewer tiles.
bool LightTiles::list_discs() {
    const std::size_t tiles = side_ * side_;
    begins_.assign(tiles + 1, 0);
    std::size_t listed = 0;
    const auto for_each_needed = [&](const Disc& disc, const auto& use) {
        for_each_row(disc, [&](std::size_t row, std::size_t left, std::size_t right) {
            const float* lowest = &lowest_[row * side_];
            for (std::size_t column = left; column <= right; ++column) {
                if (lowest[column] < disc.high()) use(row * side_ + column);
            }
        });
    };
    const std::size_t most = usual_listed + 16 * discs_.size();
    for (const Disc& disc : discs_) {
        for_each_needed(disc, [&](std::size_t at) {
            ++begins_[at];
            ++listed;
        });
        if (listed > most && side_ > fewest_tiles) {
            most_side_ = std::max(side_ / 2, fewest_tiles);
            return false;
        }
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begins_) {
        end += begin;
        begin = end;
    }
    lists_.resize(end);
    for (std::size_t i = discs_.size(); i-- > 0;) {
        for_each_needed(discs_[i], [&](std::size_t at) { lists_[--begins_[at]] = static_cast<std::uint32_t>(i); });
    }
    for (std::size_t at = 0; at < tiles; ++at) {
        if (begins_[at + 1] - begins_[at] < 2) continue;
        const auto list = std::span(lists_).subspan(begins_[at], begins_[at + 1] - begins_[at]);
        std::ranges::sort(list, [&](std::uint32_t a, std::uint32_t b) { return discs_[a].high() > discs_[b].high(); });
    }
    return true;
}

void LightTiles::decide(const LitScene& lit_scene, const glm::dvec3& direction) {
    std::size_t tried = 0;
    for (const Facing& facing : facing_) {
        if (++tried % 4096 == 0) check_cancelled();
        if (is_lit(lit_scene, direction, facing)) lit_.push_back(facing.point);
    }
    counts_.tests += static_cast<std::int64_t>(facing_.size());
}

bool LightTiles::is_lit(const LitScene& lit_scene, const glm::dvec3& direction, const Facing& facing) {
    const PointOrigin& origin = lit_scene.points.origins[facing.point];
    const std::size_t at = tile(facing.y) * side_ + tile(facing.x);
    const auto blocked = [&](std::int32_t number) {
        ++counts_.doubts;
        return number != origin.number &&
               lit_scene.places.blocked(lit_scene.pixel(origin), lit_scene.sphere(origin.number), lit_scene.side(origin.number),
                                        lit_scene.sphere(number), direction);
    };
    bool doubt = false;
    for (std::uint32_t i = begins_[at]; i < begins_[at + 1]; ++i) {
        const Disc& disc = discs_[lists_[i]];
        if (facing.height >= disc.high()) break;
        const float distance = square(facing.x - disc.x) + square(facing.y - disc.y);
        if (distance > disc.surely_out()) continue;
        if (distance < disc.surely_in() && facing.height < disc.low()) {
            // The own sphere's centre is lower than a point that faces the light, or as near as rounding; the sphere holds no
            // shadow.
            if (disc.number != origin.number) return false;
            continue;
        }
        doubt = true;
    }
    if (doubt) {
        for (std::uint32_t i = begins_[at]; i < begins_[at + 1]; ++i) {
            const Disc& disc = discs_[lists_[i]];
            if (facing.height >= disc.high()) break;
            const float distance = square(facing.x - disc.x) + square(facing.y - disc.y);
            if (distance > disc.surely_out() || (distance < disc.surely_in() && facing.height < disc.low())) continue;
            if (blocked(disc.number)) return false;
        }
    }
    return std::ranges::none_of(lit_scene.blockers.far, blocked);
}

}  // namespace sphereview

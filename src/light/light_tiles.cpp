#include "light/light_tiles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "base/square_root.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr float no_height = std::numeric_limits<float>::infinity();

constexpr std::size_t at_once = 256;  // points or spheres: what the loops below turn into SIMD stays in the nearest cache
constexpr std::size_t in_word = PointBits::in_word;
constexpr std::size_t fewest_tiles = 8;
constexpr std::size_t most_asked = 16;  // tiles that a disc asks one by one whether it is needed
using FloatLanes = std::array<float, at_once>;

// Where some points are, seen from a light.
struct Projected {
    FloatLanes x;
    FloatLanes y;
    FloatLanes height;
};

// One sum at a time: of several, which may lie in the same memory as what they are made of, the compiler makes no SIMD.
SPHEREVIEW_FOR_EACH_SIMD void dots(const float* x, const float* y, const float* z, int count, std::array<float, 3> axis,
                                   FloatLanes& out) {
    for (int i = 0; i < count; ++i) out[static_cast<std::size_t>(i)] = x[i] * axis[0] + y[i] * axis[1] + z[i] * axis[2];
}

void project(const float* x, const float* y, const float* z, int count, const LightAxes& axes, Projected& out) {
    dots(x, y, z, count, axes.across, out.x);
    dots(x, y, z, count, axes.upward, out.y);
    dots(x, y, z, count, axes.height, out.height);
}

SPHEREVIEW_FOR_EACH_SIMD void whole_dots(const std::int16_t* x, const std::int16_t* y, const std::int16_t* z, int count,
                                         std::array<float, 3> axis, FloatLanes& out) {
    for (int i = 0; i < count; ++i) {
        out[static_cast<std::size_t>(i)] =
            static_cast<float>(x[i]) * axis[0] + static_cast<float>(y[i]) * axis[1] + static_cast<float>(z[i]) * axis[2];
    }
}

// What a sphere's doubt grows with.
SPHEREVIEW_FOR_EACH_SIMD void sizes(const float* x, const float* y, const float* z, const float* radius, int count,
                                    FloatLanes& out) {
    for (int i = 0; i < count; ++i) {
        out[static_cast<std::size_t>(i)] = std::fabs(x[i]) + std::fabs(y[i]) + std::fabs(z[i]) + radius[i];
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

std::span<const std::uint64_t> LightTiles::lit(const LitScene& lit_scene, std::size_t set, const glm::dvec3& direction) {
    const glm::dvec3 l = unit(direction);
    const glm::dvec3 across = perpendicular(l);
    axes_ = {to_float(across), to_float(cross(l, across)), to_float(l)};
    const Points points{lit_scene.points.begins.at(set), lit_scene.points.begins.at(set + 1)};
    if (find_far(lit_scene, direction)) {
        light_known(lit_scene, points, direction);
        shadows_.darken(lit_scene, lit_scene.trees.known.at(set), far_, direction, left_, counts_);
    } else {
        left_.reset(points.begin, points.end);
    }
    ask_unknown(lit_scene, lit_scene.trees.unknown.at(set), direction);
    return left_.words();
}

void LightTiles::light_known(const LitScene& lit_scene, Points points, const glm::dvec3& direction) {
    do {
        choose_tiles(lit_scene.blockers, lit_scene.points.farthest);
        find_facing(lit_scene, points, direction);
        check_cancelled();
        find_discs(lit_scene);
        check_cancelled();
        cut();
        drop_what_is_cut(lit_scene, points);
    } while (!list_discs());
    decide(lit_scene, points, direction);
    std::vector<std::uint32_t>().swap(begins_);
}

bool LightTiles::find_far(const LitScene& lit_scene, const glm::dvec3& direction) {
    far_.clear();
    const HitPlace ball = lit_scene.points.ball();
    for (const std::int32_t number : lit_scene.blockers.far) {
        ++counts_.doubts;
        const Shadow shadow = lit_scene.places.shadow(ball, lit_scene.sphere(number), direction);
        if (shadow == Shadow::all) return false;
        if (shadow == Shadow::unsure) far_.push_back(number);
    }
    return true;
}

void LightTiles::choose_tiles(const Blockers& blockers, float farthest) {
    const auto root = static_cast<std::size_t>(square_root(static_cast<double>(blockers.size())));
    const double side_touched = square_root(limits_.most_touched / (blockers.covered + 1e-9));
    const auto by_discs = static_cast<std::size_t>(std::clamp(side_touched, static_cast<double>(fewest_tiles), 768.0));
    plane_ = {std::min({std::clamp<std::size_t>(root, 128, 768), by_discs, most_side_}), farthest};
    const std::size_t tiles = plane_.side() * plane_.side();
    lowest_.assign(tiles, no_height);
    coarse_.assign(coarse_side() * coarse_side(), no_height);
    cut_.assign(tiles, -no_height);
}

// Which points face the light, and the lowest of them in each tile.
void LightTiles::find_facing(const LitScene& lit_scene, Points points, const glm::dvec3& direction) {
    const LitPoints& all = lit_scene.points;
    std::array<float, 3> of_normal = axes_.height;
    for (float& component : of_normal) component /= LitPoints::normal_unit;
    const auto faces = [&](std::size_t point) {
        if (std::ranges::binary_search(all.unknown, point)) return false;  // decide() asks about them
        ++counts_.doubts;
        return lit_scene.asked(point, counts_).faces(direction);
    };
    Projected projected;
    FloatLanes facing;
    const float doubt = limits_.facing_doubt;
    left_.reset(points.begin, points.end);
    for (std::size_t from = points.begin; from < points.end; from += at_once) {
        const std::size_t count = std::min(at_once, points.end - from);
        project(&all.x[from], &all.y[from], &all.z[from], static_cast<int>(count), axes_, projected);
        whole_dots(&all.normal_x[from], &all.normal_y[from], &all.normal_z[from], static_cast<int>(count), of_normal, facing);
        for (std::size_t first = 0; first < count; first += in_word) {
            std::uint64_t word = 0;
            for (std::size_t i = first; i < std::min(first + in_word, count); ++i) {
                if (std::fabs(facing[i]) <= doubt ? !faces(from + i) : facing[i] < 0.0F) continue;
                word |= std::uint64_t{1} << (i - first);
                float& lowest = lowest_[plane_.index(projected.x[i], projected.y[i])];
                lowest = std::min(lowest, projected.height[i]);
            }
            left_.words()[(from - points.begin + first) / in_word] = word;
            counts_.points_facing += std::popcount(word);
        }
    }
    for (std::size_t y = 0; y < plane_.side(); ++y) {
        for (std::size_t x = 0; x < plane_.side(); ++x) {
            float& lowest = coarse_[(y >> coarse_shift) * coarse_side() + (x >> coarse_shift)];
            lowest = std::min(lowest, lowest_[y * plane_.side() + x]);
        }
    }
}

template <typename Keeps>
void LightTiles::sift(const LitScene& lit_scene, Points points, const Keeps& keeps) {
    const LitPoints& all = lit_scene.points;
    constexpr std::size_t words_at_once = at_once / in_word;
    Projected projected;
    const std::span<std::uint64_t> all_words = left_.words();
    for (std::size_t first = 0; first < all_words.size(); first += words_at_once) {
        const auto words = all_words.subspan(first, std::min(words_at_once, all_words.size() - first));
        if (std::ranges::all_of(words, [](std::uint64_t word) { return word == 0; })) continue;
        // The points are projected again: that takes less time than to read kept projections, and no memory.
        const std::size_t from = points.begin + first * in_word;
        project(&all.x[from], &all.y[from], &all.z[from], static_cast<int>(std::min(at_once, points.end - from)), axes_, projected);
        for (std::size_t w = 0; w < words.size(); ++w) {
            std::uint64_t kept = words[w];
            for (std::uint64_t rest = kept; rest != 0; rest &= rest - 1) {
                const std::size_t i = w * in_word + static_cast<std::size_t>(std::countr_zero(rest));
                if (!keeps(Facing{projected.x[i], projected.y[i], projected.height[i], from + i})) kept ^= rest & (~rest + 1);
            }
            words[w] = kept;
        }
    }
}

// The discs that may lie above a point of the tiles that they touch.
void LightTiles::find_discs(const LitScene& lit_scene) {
    const Blockers& blockers = lit_scene.blockers;
    Projected projected;
    FloatLanes size;
    discs_.clear();
    discs_.reserve(blockers.size());  // what is not used takes no memory
    for (std::size_t from = 0; from < blockers.size(); from += at_once) {
        const std::size_t count = std::min(at_once, blockers.size() - from);
        project(&blockers.x[from], &blockers.y[from], &blockers.z[from], static_cast<int>(count), axes_, projected);
        sizes(&blockers.x[from], &blockers.y[from], &blockers.z[from], &blockers.radius[from], static_cast<int>(count), size);
        for (std::size_t i = 0; i < count; ++i) {
            const float radius = blockers.radius[from + i];
            const float doubt = blockers.doubt(size[i]);
            const float reach = radius + 2.0F * doubt;
            const float x = projected.x[i];
            const float y = projected.y[i];
            if (std::fabs(x) - reach > plane_.half() || std::fabs(y) - reach > plane_.half()) continue;
            const float high = projected.height[i] + doubt;
            const std::size_t left = plane_.tile(x - reach);
            const std::size_t right = plane_.tile(x + reach);
            const std::size_t bottom = plane_.tile(y - reach);
            const std::size_t top = plane_.tile(y + reach);
            // A large disc asks of 8 x 8 tiles at once.
            const bool large = (right - left + 1) * (top - bottom + 1) > most_asked;
            const float* all_lowest = large ? coarse_.data() : lowest_.data();
            const std::size_t side = large ? coarse_side() : plane_.side();
            const int shift = large ? coarse_shift : 0;
            bool needed = false;
            for (std::size_t row = bottom >> shift; row <= top >> shift && !needed; ++row) {
                const float* lowest = all_lowest + row * side;
                for (std::size_t column = left >> shift; column <= right >> shift; ++column) needed |= lowest[column] < high;
            }
            if (!needed) continue;
            const std::int32_t number = lit_scene.drawn.number(lit_scene.order[from + i]);
            discs_.push_back({x, y, projected.height[i], radius, doubt, number});
        }
    }
}

// A disc that surely covers a whole tile decides every point of the tile below it.
void LightTiles::cut() {
    for (const Disc& disc : discs_) {
        const float surely_in = std::max(disc.radius - disc.doubt, 0.0F);
        plane_.for_each_covered({disc.x, disc.y, surely_in}, [&](std::size_t row, std::size_t left, std::size_t right) {
            for (float& cut : std::span(cut_).subspan(row * plane_.side() + left, right - left)) cut = std::max(cut, disc.low());
        });
    }
}

// The points that a cut leaves undecided, and the lowest of them in each tile.
void LightTiles::drop_what_is_cut(const LitScene& lit_scene, Points points) {
    std::ranges::fill(lowest_, no_height);
    sift(lit_scene, points, [&](const Facing& facing) {
        const std::size_t at = plane_.index(facing.x, facing.y);
        if (facing.height < cut_[at]) return false;
        lowest_[at] = std::min(lowest_[at], facing.height);
        return true;
    });
    std::vector<float>().swap(cut_);  // makes room for the lists
}

// Lists the discs of each tile that may lie above its lowest undecided point, the highest first. Returns false when the lists would
// be too long: the next attempt has fewer tiles.
bool LightTiles::list_discs() {
    const std::size_t side = plane_.side();
    const std::size_t tiles = side * side;
    begins_.assign(tiles + 1, 0);
    std::size_t listed = 0;
    const auto for_each_needed = [&](const Disc& disc, const auto& use) {
        plane_.for_each_touched({disc.x, disc.y, disc.reach()}, [&](std::size_t row, std::size_t left, std::size_t right) {
            const float* lowest = &lowest_[row * side];
            for (std::size_t column = left; column <= right; ++column) {
                if (lowest[column] < disc.high()) use(row * side + column);
            }
        });
    };
    const std::size_t most = limits_.usual_listed + limits_.listed_a_disc * discs_.size();
    for (const Disc& disc : discs_) {
        for_each_needed(disc, [&](std::size_t at) {
            ++begins_[at];
            ++listed;
        });
        if (listed > most && side > fewest_tiles) {
            most_side_ = std::max(side / 2, fewest_tiles);
            return false;
        }
    }
    std::uint32_t end = 0;
    for (std::uint32_t& begin : begins_) {
        end += begin;
        begin = end;
    }
    lists_.clear();
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

void LightTiles::decide(const LitScene& lit_scene, Points points, const glm::dvec3& direction) {
    std::size_t tried = 0;
    last_blocker_ = discs_.size();
    sift(lit_scene, points, [&](const Facing& facing) {
        if (++tried % 4096 == 0) check_cancelled();
        return is_lit(lit_scene, facing, direction);
    });
    counts_.tests += static_cast<std::int64_t>(tried);
}

// Whether a light shines on the points of which float knows too little.
void LightTiles::ask_unknown(const LitScene& lit_scene, const PointTree& tree, const glm::dvec3& direction) {
    if (tree.empty()) return;
    for (const std::uint32_t point : tree.points) {
        ++counts_.doubts;
        if (lit_scene.asked(point, counts_).faces(direction)) left_.give(point);
    }
    shadows_.darken(lit_scene, tree, lit_scene.trees.casting, direction, left_, counts_);
}

bool LightTiles::is_lit(const LitScene& lit_scene, const Facing& facing, const glm::dvec3& direction) {
    // What shaded the last point mostly shades its neighbour, too.
    if (last_blocker_ < discs_.size()) {
        const Disc& disc = discs_[last_blocker_];
        const float distance = square(facing.x - disc.x) + square(facing.y - disc.y);
        if (distance < disc.surely_in() && facing.height < disc.low()) return false;
    }
    const std::size_t at = plane_.index(facing.x, facing.y);
    bool doubt = false;
    for (std::uint32_t i = begins_[at]; i < begins_[at + 1]; ++i) {
        const Disc& disc = discs_[lists_[i]];
        if (facing.height >= disc.high()) break;
        const float distance = square(facing.x - disc.x) + square(facing.y - disc.y);
        if (distance > disc.surely_out()) continue;
        // Not by the own sphere, whose centre is lower than any point of it that faces the light.
        if (distance < disc.surely_in() && facing.height < disc.low()) {
            last_blocker_ = lists_[i];
            return false;
        }
        doubt = true;
    }
    if (!doubt) return true;
    const std::int32_t own = lit_scene.number(facing.point);
    AskedPoint asked = lit_scene.asked(facing.point, counts_);
    for (std::uint32_t i = begins_[at]; i < begins_[at + 1]; ++i) {
        const Disc& disc = discs_[lists_[i]];
        if (facing.height >= disc.high()) break;
        const float distance = square(facing.x - disc.x) + square(facing.y - disc.y);
        if (distance > disc.surely_out() || disc.number == own) continue;
        ++counts_.doubts;
        if (asked.blocked(lit_scene.sphere(disc.number), direction)) return false;
    }
    return true;
}

}  // namespace sphereview

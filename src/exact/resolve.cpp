#include "exact/resolve.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/parallel.hpp"
#include "exact/pixel_lanes.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

constexpr int cells_in_piece = 32;
constexpr std::size_t tried_between_checks = 4096;  // a millisecond
constexpr double condition_of_rounded_rays = 2.0;   // 4 roundings are less than 5 times this
constexpr int largest_cell_shift = 3;
static_assert(1 << 2 * largest_cell_shift == most_lanes);

template <typename Work>
void for_each_lane(LaneSet set, const Work& work) {
    for (; set != 0; set &= set - 1) work(static_cast<std::size_t>(std::countr_zero(set)));
}

// Calls work(i) for each i below `count` in an order that has nothing to do with the file's: the nearest sphere so far then changes
// as often as the logarithm of their number, and not with each of those that come farthest first.
template <typename Work>
void for_each_shuffled(std::size_t count, const Work& work) {
    constexpr std::size_t odd = 0x9E3779B97F4A7C15U;
    const std::size_t size = std::bit_ceil(count);
    for (std::size_t k = 0; k < size; ++k) {
        if (const std::size_t i = k * odd & (size - 1); i < count) work(i);
    }
}

// Sorts what has a size into groups in which sizes are at most 2^128 apart, the smallest first, if they are farther apart at all;
// it returns the groups' ends.
template <typename T, typename Size>
std::vector<std::size_t> ends_of_scales(std::vector<T>& all, const Size& size) {
    constexpr int widest = 128;
    const auto exponent = [&](const T& one) {
        const double s = size(one);
        return std::isfinite(s) ? std::ilogb(s) : std::numeric_limits<double>::max_exponent;
    };
    const auto [least, most] = std::ranges::minmax_element(all, {}, exponent);
    if (all.empty() || exponent(*most) - exponent(*least) <= widest) return {all.size()};
    const int from = exponent(*least);
    const auto group = [&](const T& one) { return (exponent(one) - from) / widest; };
    std::ranges::stable_sort(all, {}, group);
    std::vector<std::size_t> ends;
    for (std::size_t i = 1; i <= all.size(); ++i) {
        if (i == all.size() || group(all[i]) != group(all[i - 1])) ends.push_back(i);
    }
    return ends;
}

// Calls add(index) for the drawn spheres that a pixel can show, all of them without lists; it returns the distance of the nearest
// sure hit, in the units of the lists.
template <typename Add>
void for_each_candidate(const DrawnSpheres& drawn, const CandidateLists* lists, Pixel pixel, const Add& add) {
    if (lists == nullptr) {
        auto gap = drawn.gone.begin();
        for (std::uint32_t i = 0; i < drawn.size(); ++i) {
            if (gap != drawn.gone.end() && *gap == i) {
                ++gap;
            } else {
                add(i);
            }
        }
        return;
    }
    for (const TileLevel& level : lists->levels) {
        double sure_hit = NearestHits<double>::never;
        for (const Candidate& candidate : lists->at(level, pixel.x, pixel.y)) {
            if (ends_walk(candidate, sure_hit)) break;
            sure_hit = add(candidate.index);
        }
    }
}

}  // namespace

DecisionCounts& DecisionCounts::operator+=(const DecisionCounts& other) {
    in_float += other.in_float;
    in_double += other.in_double;
    exactly += other.exactly;
    integer_tests += other.integer_tests;
    return *this;
}

Resolver::Resolver(const Scene& scene, const DrawnSpheres& drawn, PictureSize size, const CandidateLists* lists)
    : Resolver(scene, drawn, scene.camera, size, lists) {}

Resolver::Resolver(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size,
                   const CandidateLists* lists)
    : scene_(scene),
      drawn_(drawn),
      camera_(camera),
      lists_(lists),
      size_(size),
      basis_(ray_basis<double>(camera, size)),
      error_scale_(error_scale(filter_condition(camera), double_unit)),
      exact_basis_(camera),
      cell_shift_(largest_cell_shift) {
    // What that basis cannot hold, aim() takes from the exact one: then the rays are only rounded.
    basis_.in_range = basis_.in_range && std::isfinite(error_scale_);
    if (!basis_.in_range) error_scale_ = error_scale(condition_of_rounded_rays, double_unit);
    if (lists != nullptr) {
        for (const TileLevel& level : lists->levels) cell_shift_ = std::min(cell_shift_, level.shift);
    }
}

bool Resolver::aim(std::span<const Pixel> pixels, std::span<glm::dvec3> rays, std::span<glm::dvec3> origins) const {
    if (basis_.orthographic && !basis_.in_range) return false;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (basis_.in_range) {
            rays[i] = unit_ray(basis_, size_, pixels[i]);
            origins[i] = ray_origin(basis_, size_, pixels[i]);
            continue;
        }
        const auto [x, y, z] = exact_basis_.ray(size_, pixels[i]);
        const glm::dvec3 ray(x.high, y.high, z.high);
        if (!(std::max({x.error, y.error, z.error}) <= double_unit * largest_of(ray))) return false;
        rays[i] = unit(ray);
    }
    return true;
}

DecisionCounts Resolver::resolve(std::span<const Pixel> pixels, std::span<std::int32_t> numbers) const {
    const LaneSet all = ~LaneSet{0} >> (most_lanes - pixels.size());
    DecisionCounts counts;

    // In double. A contest: a sphere, and the pixels that may show it.
    struct Contest {
        std::uint32_t index;
        LaneSet lanes;
    };
    std::vector<Contest> contests;
    std::array<glm::dvec3, most_lanes> rays{};
    std::array<glm::dvec3, most_lanes> origins{};
    const bool aimed = aim(pixels, rays, origins);
    const double bound_scale = aimed ? error_scale_ : NearestHits<double>::never;  // else every sphere may be anywhere
    BoundLanes lanes(std::span<const glm::dvec3>(rays).first(pixels.size()),
                     std::span<const glm::dvec3>(origins).first(basis_.orthographic ? pixels.size() : 0));
    double sure_hit = NearestHits<double>::never;  // in the units of the lists
    std::size_t tried = 0;
    for_each_candidate(drawn_, lists_, pixels.front(), [&](std::uint32_t i) {
        if (++tried % tried_between_checks == 0) check_cancelled();
        const BoundedSphere bounded(sphere(i), camera_.eye, bound_scale, basis_.reach);
        const LaneSet contending = lanes.add(i, bounded, drawn_.side(i));
        if (contending != 0) {
            contests.push_back({i, contending});
            sure_hit = lanes.farthest_sure_hit();
            if (drawn_.scale != 0) sure_hit = std::ldexp(sure_hit, drawn_.scale);
        }
        return sure_hit;
    });
    LaneSet undecided = all;
    for (std::size_t lane = 0; lane < pixels.size(); ++lane) {
        const NearestHits<double> nearest = lanes.nearest(lane);
        if (!aimed || !nearest.decided()) continue;
        undecided &= ~(LaneSet{1} << lane);
        numbers[lane] = nearest.guess < 0 ? visible_background : drawn_.number(static_cast<std::size_t>(nearest.guess));
    }
    counts.exactly = std::popcount(undecided);
    counts.in_double = static_cast<std::int64_t>(pixels.size()) - counts.exactly;
    if (undecided == 0) return counts;

    // Exactly: each sphere against the nearest so far of each pixel that may show it. Spheres of very different sizes have scales
    // of their own, the smallest first.
    std::erase_if(contests, [&](const Contest& contest) { return (contest.lanes & undecided) == 0; });
    const std::vector<std::size_t> ends =
        ends_of_scales(contests, [&](const Contest& contest) { return size_from(camera_.eye, sphere(contest.index)); });
    std::vector<std::optional<NearestHit>> nearest(pixels.size());
    DifferenceLanes differences(pixels.size());
    for_each_lane(undecided, [&](std::size_t lane) {
        nearest[lane].emplace(camera_, exact_basis_, size_, pixels[lane]);
        differences.set(lane, *nearest[lane]);
    });
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
        const std::span<const Contest> of_scale = std::span(contests).subspan(begin, end - begin);
        double largest = 0.0;
        for (const Contest& contest : of_scale) largest = std::max(largest, size_from(camera_.eye, sphere(contest.index)));
        const SphereScale scale(camera_.eye, largest);
        const auto scaled = [&](std::size_t i) { return scale(sphere(i), drawn_.number(i), drawn_.side(i)); };
        differences.use(scale);
        for_each_lane(undecided, [&](std::size_t lane) {
            nearest[lane]->rescale(scale);
            const int sure = lanes.nearest(lane).sure;
            if (sure >= 0 && ends.size() == 1) nearest[lane]->challenge(scaled(static_cast<std::size_t>(sure)));
            differences.set(lane, *nearest[lane]);
        });
        for_each_shuffled(of_scale.size(), [&](std::size_t i) {
            check_cancelled();
            const ScaledSphere challenger = scaled(of_scale[i].index);
            for_each_lane(of_scale[i].lanes & undecided & differences.challenged_by(challenger), [&](std::size_t lane) {
                if (nearest[lane]->challenge(challenger)) differences.set(lane, *nearest[lane]);
            });
        });
        begin = end;
    }
    for_each_lane(undecided, [&](std::size_t lane) {
        numbers[lane] = nearest[lane]->visible();
        counts.integer_tests += nearest[lane]->in_integers();
    });
    return counts;
}

std::int32_t Resolver::resolve(Pixel pixel, DecisionLevel& level) const {
    std::int32_t number = visible_background;
    const DecisionCounts counts = resolve(std::span(&pixel, 1), std::span(&number, 1));
    level = counts.exactly > 0 ? DecisionLevel::exactly : DecisionLevel::in_double;
    return number;
}

DecisionLevel decision_level(const Scene& scene, const DrawnSpheres& drawn, const Camera& camera, PictureSize size, Pixel pixel,
                             const CandidateLists* lists) {
    const FloatView view = float_view(camera, size, drawn.scale, gpu_unit);
    const glm::vec3 ray = unit_ray(view.rays, size, pixel);
    const glm::vec3 origin = ray_origin(view.rays, size, pixel);
    NearestHits<float> nearest;
    for_each_candidate(drawn, lists, pixel, [&](std::uint32_t i) {
        const glm::vec4& s = drawn.center_radius[i];
        if (drawn.beyond_float.contains(i)) {
            nearest.add(static_cast<int>(i), {0.0F, NearestHits<float>::never});
            return nearest.smallest_high;
        }
        const float size_of_sphere = std::fabs(s.x) + std::fabs(s.y) + std::fabs(s.z) + std::fabs(s.w) + view.rays.reach;
        const float w = view.error_scale * size_of_sphere;
        const glm::vec3 c = glm::vec3(s) - origin;
        nearest.add(static_cast<int>(i), hit_bounds(drawn.side(i), c.x, c.y, c.z, std::fabs(s.w), w, ray.x, ray.y, ray.z));
        return nearest.smallest_high;
    });
    if (!view.all_doubtful && nearest.decided()) return DecisionLevel::in_float;
    DecisionLevel level = DecisionLevel::in_double;
    Resolver(scene, drawn, camera, size, lists).resolve(pixel, level);
    return level;
}

DecisionCounts Resolver::certify(const Block& block, std::span<std::int32_t> visible,
                                 const std::function<void(double)>& progress) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    if (visible.empty()) return {};
    // Cells lie on a grid of the picture, as tiles do. Pieces are some cells beside each other, or what the block has of them.
    const int high = 1 << cell_shift_;
    const int wide = cells_in_piece << cell_shift_;
    const int left = block.x / wide;
    const int top = block.y / high;
    const int across = (block.x + block.width - 1) / wide - left + 1;
    const int down = (block.y + block.height - 1) / high - top + 1;
    const auto pieces = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    const auto caller = std::this_thread::get_id();
    std::mutex mutex;
    DecisionCounts all;
    std::size_t done = 0;
    parallel_for(pieces, [&](std::size_t piece) {
        const int x = (left + static_cast<int>(piece) % across) * wide;
        const int y = (top + static_cast<int>(piece) / across) * high;
        const int begin_x = std::max(x, block.x);
        const int begin_y = std::max(y, block.y);
        const Block part{begin_x, begin_y, std::min(x + wide, block.x + block.width) - begin_x,
                         std::min(y + high, block.y + block.height) - begin_y};
        const DecisionCounts counts = certify_piece(part, block, visible);
        double done_part = 0.0;
        {
            const std::lock_guard lock(mutex);
            all += counts;
            done_part = static_cast<double>(++done) / static_cast<double>(pieces);
        }
        if (progress && std::this_thread::get_id() == caller) progress(done_part);
    });
    all.in_float = static_cast<std::int64_t>(visible.size()) - all.in_double - all.exactly;
    return all;
}

DecisionCounts Resolver::certify_piece(const Block& piece, const Block& block, std::span<std::int32_t> visible) const {
    const auto number_at = [&](int x, int y) -> std::int32_t& {
        return visible[static_cast<std::size_t>(y - block.y) * static_cast<std::size_t>(block.width) +
                       static_cast<std::size_t>(x - block.x)];
    };
    const bool renumber = !drawn_.numbers.empty();
    std::vector<Pixel> pixels;  // the doubtful ones
    for (int y = piece.y; y < piece.y + piece.height; ++y) {
        std::int32_t* row = &number_at(piece.x, y);
        for (int i = 0; i < piece.width; ++i) {
            if (is_doubtful(row[i])) {
                pixels.push_back({piece.x + i, y});
            } else if (row[i] >= 0 && renumber) {
                row[i] = drawn_.numbers[static_cast<std::size_t>(row[i])];
            }
        }
    }
    // Cell by cell.
    const auto cell_of = [this](const Pixel& pixel) { return pixel.x >> cell_shift_; };
    std::ranges::stable_sort(pixels, {}, cell_of);
    DecisionCounts counts;
    std::array<std::int32_t, most_lanes> numbers{};
    for (std::size_t begin = 0, end = 0; begin < pixels.size(); begin = end) {
        while (end < pixels.size() && cell_of(pixels[end]) == cell_of(pixels[begin])) ++end;
        const auto cell = std::span(pixels).subspan(begin, end - begin);
        counts += resolve(cell, std::span(numbers).first(cell.size()));
        for (std::size_t i = 0; i < cell.size(); ++i) number_at(cell[i].x, cell[i].y) = numbers[i];
    }
    return counts;
}

void Resolver::accept_guesses(std::span<std::int32_t> visible) const {
    for (std::int32_t& number : visible) {
        if (is_doubtful(number)) number = doubtful(number);
        if (number >= 0) number = drawn_.number(static_cast<std::size_t>(number));
    }
}

}  // namespace sphereview

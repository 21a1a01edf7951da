#include "exact/resolve.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/parallel.hpp"
#include "exact/pixel_lanes.hpp"
#include "scene/vectors.hpp"

namespace sphereview {

namespace {

template <typename Real>
HitBounds<Real> bounds_of_side(EyeSide side, const glm::vec<3, Real>& c, Real r, Real w, const glm::vec<3, Real>& ray) {
    switch (side) {
        case EyeSide::outside: return hit_bounds<EyeSide::outside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::inside: return hit_bounds<EyeSide::inside>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
        case EyeSide::on_surface: return hit_bounds<EyeSide::on_surface>(c.x, c.y, c.z, r, w, ray.x, ray.y, ray.z);
    }
    return {};
}

constexpr std::size_t cells_at_once = 4;
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
      frame_(ray_basis<double>(camera, size)),
      error_scale_(error_scale(ray_condition(camera), double_unit)),
      exact_basis_(camera),
      cell_shift_(largest_cell_shift) {
    frame_.in_range = frame_.in_range && std::isfinite(error_scale_);
    if (!frame_.in_range) error_scale_ = NearestHits<double>::never;  // every sphere may be anywhere
    if (lists != nullptr) {
        for (const TileLevel& level : lists->levels) cell_shift_ = std::min(cell_shift_, level.shift);
    }
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
    BoundLanes lanes(frame_, size_, pixels);
    for_each_candidate(drawn_, lists_, pixels.front(), [&](std::uint32_t i) {
        const BoundedSphere bounded(sphere(i), camera_.eye, error_scale_);
        if (const LaneSet contending = lanes.add(i, bounded, drawn_.side(i))) contests.push_back({i, contending});
        if (lists_ == nullptr) return 0.0;
        const double sure_hit = lanes.farthest_sure_hit();
        return drawn_.scale == 0 ? sure_hit : std::ldexp(sure_hit, drawn_.scale);
    });
    LaneSet undecided = all;
    for (std::size_t lane = 0; lane < pixels.size(); ++lane) {
        const NearestHits<double> nearest = lanes.nearest(lane);
        if (!frame_.in_range || !nearest.decided()) continue;
        undecided &= ~(LaneSet{1} << lane);
        numbers[lane] = nearest.guess < 0 ? visible_background : drawn_.number(static_cast<std::size_t>(nearest.guess));
    }
    counts.exactly = std::popcount(undecided);
    counts.in_double = static_cast<std::int64_t>(pixels.size()) - counts.exactly;
    if (undecided == 0) return counts;

    // Exactly: each sphere against the nearest so far of each pixel that may show it.
    std::erase_if(contests, [&](const Contest& contest) { return (contest.lanes & undecided) == 0; });
    double largest = largest_of(camera_.eye);
    for (const Contest& contest : contests) {
        largest = std::max({largest, largest_of(sphere(contest.index).center), sphere(contest.index).radius});
    }
    const SphereScale scale(camera_.eye, largest);
    const auto scaled = [&](std::size_t i) { return scale(sphere(i), drawn_.number(i), drawn_.side(i)); };
    std::vector<std::optional<NearestHit>> nearest(pixels.size());
    DifferenceLanes differences(pixels.size());
    for_each_lane(undecided, [&](std::size_t lane) {
        nearest[lane].emplace(camera_, exact_basis_, size_, pixels[lane]);
        if (const int sure = lanes.nearest(lane).sure; sure >= 0) nearest[lane]->challenge(scaled(static_cast<std::size_t>(sure)));
        differences.set(lane, *nearest[lane]);
    });
    for_each_shuffled(contests.size(), [&](std::size_t i) {
        check_cancelled();
        const ScaledSphere challenger = scaled(contests[i].index);
        for_each_lane(contests[i].lanes & undecided & differences.challenged_by(challenger), [&](std::size_t lane) {
            if (nearest[lane]->challenge(challenger)) differences.set(lane, *nearest[lane]);
        });
    });
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
    const FloatView view = float_view(camera, size, gpu_unit);
    const glm::vec3 ray = unit_ray(view.rays, size, pixel);
    NearestHits<float> nearest;
    for_each_candidate(drawn, lists, pixel, [&](std::uint32_t i) {
        const glm::vec4& s = drawn.center_radius[i];
        const float w = view.error_scale * (std::fabs(s.x) + std::fabs(s.y) + std::fabs(s.z) + std::fabs(s.w));
        const EyeSide side = s.w > 0.0F ? EyeSide::outside : s.w < 0.0F ? EyeSide::inside : EyeSide::on_surface;
        nearest.add(static_cast<int>(i), bounds_of_side<float>(side, glm::vec3(s), std::fabs(s.w), w, ray));
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
    // Cells lie on a grid of the picture, as tiles do.
    const int left = block.x >> cell_shift_;
    const int top = block.y >> cell_shift_;
    const int across = ((block.x + block.width - 1) >> cell_shift_) - left + 1;
    const int down = ((block.y + block.height - 1) >> cell_shift_) - top + 1;
    const std::size_t cells = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    const auto caller = std::this_thread::get_id();
    std::mutex mutex;
    DecisionCounts all;
    std::size_t done = 0;
    parallel_pieces(cells, cells_at_once, [&](std::size_t begin, std::size_t end) {
        DecisionCounts counts;
        for (std::size_t cell = begin; cell < end; ++cell) {
            const int x = left + static_cast<int>(cell % static_cast<std::size_t>(across));
            const int y = top + static_cast<int>(cell / static_cast<std::size_t>(across));
            counts += certify_cell({x << cell_shift_, y << cell_shift_}, block, visible);
        }
        double part = 0.0;
        {
            const std::lock_guard lock(mutex);
            all += counts;
            done += end - begin;
            part = static_cast<double>(done) / static_cast<double>(cells);
        }
        if (progress && std::this_thread::get_id() == caller) progress(part);
    });
    all.in_float = static_cast<std::int64_t>(visible.size()) - all.in_double - all.exactly;
    return all;
}

DecisionCounts Resolver::certify_cell(Pixel cell, const Block& block, std::span<std::int32_t> visible) const {
    const bool renumber = !drawn_.numbers.empty();
    std::array<Pixel, most_lanes> pixels;
    std::array<std::int32_t*, most_lanes> places{};
    std::size_t count = 0;
    const int side = 1 << cell_shift_;
    for (int y = std::max(cell.y, block.y); y < std::min(cell.y + side, block.y + block.height); ++y) {
        std::int32_t* row = visible.data() + static_cast<std::ptrdiff_t>(y - block.y) * block.width - block.x;
        for (int x = std::max(cell.x, block.x); x < std::min(cell.x + side, block.x + block.width); ++x) {
            if (is_doubtful(row[x])) {
                pixels[count] = {x, y};
                places[count++] = row + x;
            } else if (row[x] >= 0 && renumber) {
                row[x] = drawn_.numbers[static_cast<std::size_t>(row[x])];
            }
        }
    }
    if (count == 0) return {};
    std::array<std::int32_t, most_lanes> numbers{};
    const DecisionCounts counts = resolve(std::span(pixels).first(count), std::span(numbers).first(count));
    for (std::size_t i = 0; i < count; ++i) *places[i] = numbers[i];
    return counts;
}

void Resolver::accept_guesses(std::span<std::int32_t> visible) const {
    for (std::int32_t& number : visible) {
        if (is_doubtful(number)) number = doubtful(number);
        if (number >= 0) number = drawn_.number(static_cast<std::size_t>(number));
    }
}

}  // namespace sphereview

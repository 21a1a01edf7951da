#include "light/spatial_order.hpp"

#include <algorithm>
#include <limits>
#include <mutex>

#include "base/parallel.hpp"
#include "base/uninitialized.hpp"

namespace sphereview {

namespace {

constexpr std::size_t indices_at_once = 16384;
constexpr int cell_bits = 6;  // an axis
constexpr double cells_across = 64.0;
static_assert(SpatialGrid::cells == std::size_t{1} << (3 * cell_bits));

// The bits of `cell`, with two zeros after each.
std::uint32_t spread(std::uint32_t cell) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < cell_bits; ++bit) result |= (cell >> bit & 1U) << (3 * bit);
    return result;
}

// Halves, so that no difference of doubles overflows.
std::uint32_t cell_along(double low, double high, double at) {
    const double extent = 0.5 * high - 0.5 * low;
    const double cell = extent > 0.0 ? cells_across * ((0.5 * at - 0.5 * low) / extent) : 0.0;
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, cells_across - 1.0));
}

// Calls use(i, centre) for the indices in [begin, end) that are no gaps.
template <typename Use>
void for_each_center(const Scene& scene, const DrawnSpheres& drawn, std::size_t begin, std::size_t end, const Use& use) {
    auto gap = std::ranges::lower_bound(drawn.gone, begin);
    for (std::size_t i = begin; i < end; ++i) {
        if (gap != drawn.gone.end() && *gap == i) {
            ++gap;
        } else {
            use(i, scene.spheres[static_cast<std::size_t>(drawn.number(i))].center);
        }
    }
}

}  // namespace

SpatialGrid::SpatialGrid(const Scene& scene, const DrawnSpheres& drawn) {
    if (drawn.size() == drawn.gone.size()) return;
    low_ = glm::dvec3(std::numeric_limits<double>::max());
    high_ = -low_;
    std::mutex joining;
    parallel_pieces(drawn.size(), indices_at_once, [&](std::size_t begin, std::size_t end) {
        glm::dvec3 low(std::numeric_limits<double>::max());
        glm::dvec3 high = -low;
        const auto include = [](glm::dvec3& least, glm::dvec3& most, const glm::dvec3& from, const glm::dvec3& to) {
            for (int axis = 0; axis < 3; ++axis) {
                least[axis] = std::min(least[axis], from[axis]);
                most[axis] = std::max(most[axis], to[axis]);
            }
        };
        for_each_center(scene, drawn, begin, end, [&](std::size_t, const glm::dvec3& c) { include(low, high, c, c); });
        const std::lock_guard lock(joining);
        include(low_, high_, low, high);
    });
}

std::uint32_t SpatialGrid::cell(const glm::dvec3& center) const {
    return spread(cell_along(low_.x, high_.x, center.x)) | spread(cell_along(low_.y, high_.y, center.y)) << 1 |
           spread(cell_along(low_.z, high_.z, center.z)) << 2;
}

std::vector<std::uint32_t> spatial_order(const Scene& scene, const DrawnSpheres& drawn, const SpatialGrid& grid) {
    constexpr auto gap = static_cast<std::uint32_t>(SpatialGrid::cells);  // behind all
    UninitializedVector<std::uint32_t> cells(drawn.size());
    parallel_pieces(drawn.size(), indices_at_once, [&](std::size_t begin, std::size_t end) {
        std::fill(cells.begin() + static_cast<std::ptrdiff_t>(begin), cells.begin() + static_cast<std::ptrdiff_t>(end), gap);
        for_each_center(scene, drawn, begin, end, [&](std::size_t i, const glm::dvec3& c) { cells[i] = grid.cell(c); });
    });
    std::vector<std::uint32_t> places(SpatialGrid::cells + 1, 0);
    for (const std::uint32_t cell : cells) {
        if (cell != gap) ++places[cell + std::size_t{1}];
    }
    for (std::size_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
    std::vector<std::uint32_t> order(drawn.size() - drawn.gone.size());
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        if (cells[i] != gap) order[places[cells[i]]++] = i;
    }
    return order;
}

}  // namespace sphereview

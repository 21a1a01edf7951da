#include "light/spatial_order.hpp"

#include <algorithm>
#include <cstddef>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

constexpr std::size_t indices_at_once = 16384;
constexpr int cell_bits = 6;  // an axis
constexpr double cells_across = 64.0;

// Its bits, two zeros after each.
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

}  // namespace

std::vector<std::uint32_t> spatial_order(const Scene& scene, const DrawnSpheres& drawn) {
    std::vector<std::uint32_t> indices;
    indices.reserve(drawn.size());
    auto gap = drawn.gone.begin();
    for (std::uint32_t i = 0; i < drawn.size(); ++i) {
        if (gap != drawn.gone.end() && *gap == i) {
            ++gap;
        } else {
            indices.push_back(i);
        }
    }
    if (indices.empty()) return indices;
    const auto center = [&](std::uint32_t index) -> const glm::dvec3& {
        return scene.spheres[static_cast<std::size_t>(drawn.number(index))].center;
    };
    glm::dvec3 low = center(indices.front());
    glm::dvec3 high = low;
    for (const std::uint32_t index : indices) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], center(index)[axis]);
            high[axis] = std::max(high[axis], center(index)[axis]);
        }
    }
    const auto cell = [&](std::uint32_t index) {
        const glm::dvec3& c = center(index);
        return spread(cell_along(low.x, high.x, c.x)) | spread(cell_along(low.y, high.y, c.y)) << 1 |
               spread(cell_along(low.z, high.z, c.z)) << 2;
    };
    std::vector<std::uint32_t> cells(indices.size());
    parallel_pieces(indices.size(), indices_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) cells[i] = cell(indices[i]);
    });
    std::vector<std::uint32_t> places((std::size_t{1} << (3 * cell_bits)) + 1, 0);
    for (const std::uint32_t its_cell : cells) ++places[its_cell + std::size_t{1}];
    for (std::size_t i = 1; i < places.size(); ++i) places[i] += places[i - 1];
    std::vector<std::uint32_t> order(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) order[places[cells[i]]++] = indices[i];
    return order;
}

}  // namespace sphereview

// The same filter as shaders/trace.frag, a small square of pixels (a cell) at a time so that the compiler can use SIMD.
#include "cpu/cpu_renderer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

#include "base/parallel.hpp"
#include "base/simd.hpp"
#include "base/square_root.hpp"

namespace sphereview {

namespace {

constexpr int cell_side = 1 << cpu_cell_shift;
constexpr int cell_size = cell_side * cell_side;
constexpr float never = NearestHits<float>::never;

using Lane = std::array<float, cell_size>;
using IndexLane = std::array<std::int32_t, cell_size>;

// The unit directions of a cell's rays. Orthographic: one for all, and where the rays begin, relative to the eye.
struct Rays {
    Lane x;
    Lane y;
    Lane z;
    bool orthographic;
    Lane origin_x;
    Lane origin_y;
    Lane origin_z;
};

// NearestHits (exact/filter.hpp) for a cell's rays.
struct Nearest {
    Lane smallest_high;
    Lane low;
    Lane second_low;
    IndexLane sure;
    IndexLane guess;
};

// A sphere as one of the rays has it: relative to where the ray begins.
template <bool in_eye>
glm::vec3 from_origin(const Rays& rays, int i, const glm::vec4& sphere) {
    if constexpr (in_eye) return {sphere.x, sphere.y, sphere.z};
    return {sphere.x - rays.origin_x[i], sphere.y - rays.origin_y[i], sphere.z - rays.origin_z[i]};
}

// Beyond the picture's edge the last pixel's ray is repeated.
void aim(Rays& rays, const RayBasis<float>& basis, PictureSize size, Pixel cell) {
    const RayCoefficients first = ray_coefficients(size, cell);
    const int last_x = std::min(cell_side, size.width - cell.x) - 1;
    const int last_y = std::min(cell_side, size.height - cell.y) - 1;
    rays.orthographic = basis.orthographic;
    if (rays.orthographic) {
        const glm::vec3 ray = unit_ray(basis, size, cell);
        for (int i = 0; i < cell_size; ++i) {
            const int column = std::min(i % cell_side, last_x);
            const int row = std::min(i / cell_side, last_y);
            const glm::vec3 origin = ray_origin(basis, size, {cell.x + column, cell.y + row});
            rays.x[i] = ray.x;
            rays.y[i] = ray.y;
            rays.z[i] = ray.z;
            rays.origin_x[i] = origin.x;
            rays.origin_y[i] = origin.y;
            rays.origin_z[i] = origin.z;
        }
        return;
    }
    for (int row = 0; row < cell_side; ++row) {
        const auto upward = static_cast<float>(static_cast<std::int32_t>(first.upward) - 2 * std::min(row, last_y));
        const glm::vec3 middle = basis.forward + upward * basis.up;
        for (int column = 0; column < cell_side; ++column) {
            const auto across = static_cast<float>(static_cast<std::int32_t>(first.across) + 2 * std::min(column, last_x));
            const float x = middle.x + across * basis.right.x;
            const float y = middle.y + across * basis.right.y;
            const float z = middle.z + across * basis.right.z;
            const float scale = 1.0F / square_root(x * x + y * y + z * z);
            const int i = row * cell_side + column;
            rays.x[i] = x * scale;
            rays.y[i] = y * scale;
            rays.z[i] = z * scale;
        }
    }
}

// Whether all rays surely miss, from outside: without square roots, by twice the bound.
template <bool in_eye>
bool all_miss(const Rays& rays, const glm::vec4& sphere, float w) {
    const float reach = sphere.w + 2.0F * w;
    const float reach_square = reach * reach;
    int near = 0;
    for (int i = 0; i < cell_size; ++i) {
        const glm::vec3 c = from_origin<in_eye>(rays, i, sphere);
        const float along = c.x * rays.x[i] + c.y * rays.y[i] + c.z * rays.z[i];
        const float px = c.x - along * rays.x[i];
        const float py = c.y - along * rays.y[i];
        const float pz = c.z - along * rays.z[i];
        near |= static_cast<int>(px * px + py * py + pz * pz <= reach_square);
    }
    return near == 0;
}

template <EyeSide side, bool in_eye>
void add_sphere(Nearest& nearest, const Rays& rays, std::int32_t index, const glm::vec4& sphere, float w) {
    const float radius = std::fabs(sphere.w);
    for (int i = 0; i < cell_size; ++i) {
        const glm::vec3 c = from_origin<in_eye>(rays, i, sphere);
        const HitBounds<float> hit = hit_bounds<side>(c.x, c.y, c.z, radius, w, rays.x[i], rays.y[i], rays.z[i]);
        // All loads before all stores: a conditional one would keep this from becoming SIMD.
        const float low = nearest.low[i];
        const float second_low = nearest.second_low[i];
        const float smallest_high = nearest.smallest_high[i];
        const std::int32_t guess = nearest.guess[i];
        const std::int32_t sure = nearest.sure[i];
        const bool nearer = hit.low < low;
        const float displaced = nearer ? low : hit.low;
        nearest.second_low[i] = displaced < second_low ? displaced : second_low;
        nearest.low[i] = nearer ? hit.low : low;
        nearest.guess[i] = nearer ? index : guess;
        const bool surer = hit.high < smallest_high;
        nearest.smallest_high[i] = surer ? hit.high : smallest_high;
        nearest.sure[i] = surer ? index : sure;
    }
}

// The largest of the smallest sure distances. They are positive, and floats that are compare like integers, of which the
// compiler knows that their order of comparison does not matter.
float farthest(const Lane& smallest_high) {
    std::int32_t most = 0;
    for (const float high : smallest_high) {
        const auto bits = std::bit_cast<std::int32_t>(high);
        most = most < bits ? bits : most;
    }
    return std::bit_cast<float>(most);
}

void add_candidate(Nearest& nearest, const Rays& rays, std::int32_t index, const glm::vec4& sphere, float error_scale) {
    const float w = error_scale * (std::fabs(sphere.x) + std::fabs(sphere.y) + std::fabs(sphere.z) + std::fabs(sphere.w));
    if (sphere.w > 0.0F) {
        if (!all_miss<true>(rays, sphere, w)) add_sphere<EyeSide::outside, true>(nearest, rays, index, sphere, w);
    } else if (sphere.w < 0.0F) {
        add_sphere<EyeSide::inside, true>(nearest, rays, index, sphere, w);
    } else {
        add_sphere<EyeSide::on_surface, true>(nearest, rays, index, sphere, w);
    }
}

// `reach`: of the rays' origins.
void add_orthographic_candidate(Nearest& nearest, const Rays& rays, std::int32_t index, const glm::vec4& sphere, float error_scale,
                                float reach) {
    const float w = error_scale * (std::fabs(sphere.x) + std::fabs(sphere.y) + std::fabs(sphere.z) + std::fabs(sphere.w) + reach);
    if (sphere.w > 0.0F) {
        if (!all_miss<false>(rays, sphere, w)) add_sphere<EyeSide::outside, false>(nearest, rays, index, sphere, w);
    } else if (sphere.w < 0.0F) {
        add_sphere<EyeSide::in_plane, false>(nearest, rays, index, sphere, w);
    } else {  // beyond float: perhaps hit, anywhere
        add_sphere<EyeSide::on_surface, true>(nearest, rays, index, sphere, 0.0F);
    }
}

}  // namespace

CpuRenderer::CpuRenderer(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size)
    : spheres_(spheres), lists_(lists), view_(float_view(camera, size, spheres.scale, float_unit)), size_(size) {}

void CpuRenderer::trace(const Block& block, std::span<std::int32_t> visible) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    if (block.width <= 0 || block.height <= 0) return;
    // Cells lie on a grid of the picture, as tiles do.
    const int left = block.x >> cpu_cell_shift;
    const int top = block.y >> cpu_cell_shift;
    const int across = ((block.x + block.width - 1) >> cpu_cell_shift) - left + 1;
    const int down = ((block.y + block.height - 1) >> cpu_cell_shift) - top + 1;
    constexpr std::size_t cells_at_once = 16;
    parallel_pieces(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), cells_at_once,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t cell = begin; cell < end; ++cell) {
                            check_cancelled();  // a cell may try a million spheres
                            const int x = left + static_cast<int>(cell % static_cast<std::size_t>(across));
                            const int y = top + static_cast<int>(cell / static_cast<std::size_t>(across));
                            trace_cell({x * cell_side, y * cell_side}, block, visible.data());
                        }
                    });
}

SPHEREVIEW_FOR_EACH_SIMD
void CpuRenderer::trace_cell(Pixel cell, const Block& block, std::int32_t* visible) const {
    Rays rays;
    aim(rays, view_.rays, size_, cell);
    Nearest nearest;
    nearest.smallest_high.fill(never);
    nearest.low.fill(never);
    nearest.second_low.fill(never);
    nearest.sure.fill(-1);
    nearest.guess.fill(-1);

    for (const TileLevel& level : lists_.levels) {
        for (const Candidate& candidate : lists_.at(level, cell.x, cell.y)) {
            if (ends_walk(candidate, farthest(nearest.smallest_high))) break;
            const auto index = static_cast<std::int32_t>(candidate.index);
            const glm::vec4& sphere = spheres_.center_radius[candidate.index];
            if (rays.orthographic) {
                add_orthographic_candidate(nearest, rays, index, sphere, view_.error_scale, view_.rays.reach);
            } else {
                add_candidate(nearest, rays, index, sphere, view_.error_scale);
            }
        }
    }

    const int first_x = std::max(cell.x, block.x);
    const int first_y = std::max(cell.y, block.y);
    const int end_x = std::min(cell.x + cell_side, block.x + block.width);
    const int end_y = std::min(cell.y + cell_side, block.y + block.height);
    for (int y = first_y; y < end_y; ++y) {
        std::int32_t* out = visible + static_cast<std::ptrdiff_t>(y - block.y) * block.width - block.x;
        for (int x = first_x; x < end_x; ++x) {
            const int i = (y - cell.y) * cell_side + (x - cell.x);
            const std::int32_t guess = nearest.guess[i];
            const bool decided =
                !view_.all_doubtful && guess == nearest.sure[i] && (guess < 0 || nearest.second_low[i] > nearest.smallest_high[i]);
            out[x] = decided ? guess : doubtful(guess);
        }
    }
}

}  // namespace sphereview

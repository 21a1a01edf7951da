// The same filter as shaders/trace.frag, a run of pixels at a time so that the compiler can use SIMD.
#include "cpu/cpu_renderer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/parallel.hpp"

// Where the loader can choose among versions of a function by the processor at hand, wide SIMD serves those that have it.
// Same bits: without contraction every operation is IEEE 754's, however many at a time. (Sanitizers start too late for it.)
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SPHEREVIEW_FOR_EACH_SIMD __attribute__((target_clones("default", "avx2", "arch=x86-64-v4"), flatten))
#else
#define SPHEREVIEW_FOR_EACH_SIMD
#endif

namespace sphereview {

namespace {

constexpr int run_length = 128;  // pixels whose rays and nearest hits stay in the first-level cache
constexpr float never = NearestHits<float>::never;

using Lane = std::array<float, run_length>;
using IndexLane = std::array<std::int32_t, run_length>;

// The unit directions of a run of rays.
struct Rays {
    Lane x;
    Lane y;
    Lane z;
};

// NearestHits (exact/filter.hpp) for a run of rays.
struct Nearest {
    Lane smallest_high;
    Lane low;
    Lane second_low;
    IndexLane sure;
    IndexLane guess;
};

void aim(Rays& rays, const RayFrame<float>& frame, const RayCoefficients& first) {
    const glm::vec3 row = frame.forward + static_cast<float>(first.upward) * frame.up;
    for (int i = 0; i < run_length; ++i) {
        const auto across = static_cast<float>(static_cast<std::int32_t>(first.across) + 2 * i);
        const float x = row.x + across * frame.right.x;
        const float y = row.y + across * frame.right.y;
        const float z = row.z + across * frame.right.z;
        const float scale = 1.0F / std::sqrt(x * x + y * y + z * z);
        rays.x[i] = x * scale;
        rays.y[i] = y * scale;
        rays.z[i] = z * scale;
    }
}

// Whether all rays of the run surely miss, from outside: without square roots, by twice the bound.
bool all_miss(const Rays& rays, const glm::vec4& sphere, float w) {
    const float reach = sphere.w + 2.0F * w;
    const float reach_square = reach * reach;
    int near = 0;
    for (int i = 0; i < run_length; ++i) {
        const float along = sphere.x * rays.x[i] + sphere.y * rays.y[i] + sphere.z * rays.z[i];
        const float px = sphere.x - along * rays.x[i];
        const float py = sphere.y - along * rays.y[i];
        const float pz = sphere.z - along * rays.z[i];
        near |= static_cast<int>(px * px + py * py + pz * pz <= reach_square);
    }
    return near == 0;
}

template <EyeSide side>
void add_sphere(Nearest& nearest, const Rays& rays, std::int32_t index, const glm::vec4& sphere, float w) {
    const float radius = std::fabs(sphere.w);
    for (int i = 0; i < run_length; ++i) {
        const HitBounds<float> hit = hit_bounds<side>(sphere.x, sphere.y, sphere.z, radius, w, rays.x[i], rays.y[i], rays.z[i]);
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

}  // namespace

CpuRenderer::CpuRenderer(const DrawnSpheres& spheres, const Camera& camera, PictureSize size)
    : spheres_(spheres), view_(float_view(spheres, camera, size, float_unit)), size_(size) {}

void CpuRenderer::trace(const Block& block, std::span<std::int32_t> visible) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    const int runs = (block.width + run_length - 1) / run_length;
    parallel_for(static_cast<std::size_t>(block.height), [&](std::size_t in_block) {
        const auto row = static_cast<int>(in_block);
        for (int run = 0; run < runs; ++run) {
            const int begin = run * run_length;
            trace_run(block.x + begin, block.y + row, std::min(run_length, block.width - begin),
                      visible.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(block.width) + begin);
        }
    });
}

SPHEREVIEW_FOR_EACH_SIMD
void CpuRenderer::trace_run(int x, int y, int count, std::int32_t* visible) const {
    Rays rays;
    aim(rays, view_.rays, ray_coefficients(size_, {x, y}));
    Nearest nearest;
    nearest.smallest_high.fill(never);
    nearest.low.fill(never);
    nearest.second_low.fill(never);
    nearest.sure.fill(-1);
    nearest.guess.fill(-1);

    std::int32_t index = 0;
    for (const glm::vec4& sphere : spheres_.center_radius) {
        const float w = view_.error_scale * (std::fabs(sphere.x) + std::fabs(sphere.y) + std::fabs(sphere.z) + std::fabs(sphere.w));
        if (sphere.w > 0.0F) {
            if (!all_miss(rays, sphere, w)) add_sphere<EyeSide::outside>(nearest, rays, index, sphere, w);
        } else if (sphere.w < 0.0F) {
            add_sphere<EyeSide::inside>(nearest, rays, index, sphere, w);
        } else {
            add_sphere<EyeSide::on_surface>(nearest, rays, index, sphere, w);
        }
        ++index;
    }
    for (int i = 0; i < count; ++i) {
        const std::int32_t guess = nearest.guess[i];
        const bool decided =
            !view_.all_doubtful && guess == nearest.sure[i] && (guess < 0 || nearest.second_low[i] > nearest.smallest_high[i]);
        visible[i] = decided ? guess : doubtful(guess);
    }
}

}  // namespace sphereview

// The same arithmetic as shaders/trace.frag, a run of pixels at a time so that the compiler can use SIMD.
#include "cpu/cpu_renderer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace sphereview {

namespace {

constexpr int run_length = 128;  // pixels whose rays and nearest hits stay in the first-level cache

using Lane = std::array<float, run_length>;

}  // namespace

CpuRenderer::CpuRenderer(const DrawnSpheres& spheres, const Camera& camera, PictureSize size)
    : spheres_(spheres), frame_(ray_frame(camera, size)), size_(size) {}

void CpuRenderer::trace(const Block& block, std::span<std::int32_t> visible) const {
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    const int runs = (block.width + run_length - 1) / run_length;
#pragma omp parallel for collapse(2) schedule(dynamic, 8)
    for (int row = 0; row < block.height; ++row) {
        for (int run = 0; run < runs; ++run) {
            const int begin = run * run_length;
            trace_run(block.x + begin, block.y + row, std::min(run_length, block.width - begin),
                      visible.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(block.width) + begin);
        }
    }
}

void CpuRenderer::trace_run(int x, int y, int count, std::int32_t* visible) const {
    Lane nx;
    Lane ny;
    Lane nz;
    Lane nearest;
    std::array<std::int32_t, run_length> best;
    const auto upward = static_cast<float>(ray_coefficients(size_, {x, y}).upward);
    const glm::vec3 row = frame_.forward + upward * frame_.up;
    const long long first_across = ray_coefficients(size_, {x, y}).across;
    for (int i = 0; i < run_length; ++i) {
        const auto across = static_cast<float>(first_across + 2LL * i);
        const float dx = row.x + across * frame_.right.x;
        const float dy = row.y + across * frame_.right.y;
        const float dz = row.z + across * frame_.right.z;
        const float scale = 1.0F / std::sqrt(dx * dx + dy * dy + dz * dz);
        nx[i] = dx * scale;
        ny[i] = dy * scale;
        nz[i] = dz * scale;
        nearest[i] = std::numeric_limits<float>::infinity();
        best[i] = visible_background;
    }
    std::int32_t index = 0;
    for (const glm::vec4& sphere : spheres_.center_radius) {
        for (int i = 0; i < run_length; ++i) {
            // Haines, Guenther and Akenine-Moeller, "Precision improvements for ray/sphere intersection", 2019: the
            // closest approach first, because b^2 - c cancels.
            const float along = sphere.x * nx[i] + sphere.y * ny[i] + sphere.z * nz[i];
            const float px = sphere.x - along * nx[i];
            const float py = sphere.y - along * ny[i];
            const float pz = sphere.z - along * nz[i];
            const float h = std::sqrt(px * px + py * py + pz * pz);
            const float half_chord = std::sqrt(std::max((sphere.w - h) * (sphere.w + h), 0.0F));
            const float in = along - half_chord;
            const float t = in > 0.0F ? in : along + half_chord;
            const bool closer = (h <= sphere.w) & (t > 0.0F) & (t < nearest[i]);
            nearest[i] = closer ? t : nearest[i];
            best[i] = closer ? index : best[i];
        }
        ++index;
    }
    std::copy_n(best.begin(), count, visible);
}

}  // namespace sphereview

#include "app/render_picture.hpp"

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "cpu/cpu_renderer.hpp"
#include "shade/shade.hpp"

namespace sphereview {

namespace {

// Calls trace(block, visible) for one block after the other, maps what it wrote to the scene's numbers and colours it.
template <typename Trace>
void for_each_block(const Scene& scene, const Background& background, const DrawnSpheres& drawn, Image& picture, int block_width,
                    int block_height, Timings& timings, Progress& progress, const Trace& trace) {
    std::vector<std::int32_t> visible;
    const double rows = picture.height();
    for (int y = 0; y < picture.height(); y += block_height) {
        for (int x = 0; x < picture.width(); x += block_width) {
            const Block block{x, y, std::min(block_width, picture.width() - x), std::min(block_height, picture.height() - y)};
            visible.resize(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
            trace(block, std::span(visible));
            const PhaseTimer timer(timings, Phase::resolve);
            to_scene_numbers(drawn, visible);
            shade_flat(scene, background, block, visible, picture);
            progress.update((y + block.height * static_cast<double>(x + block.width) / picture.width()) / rows);
        }
    }
}

// Rows of a CPU block: enough work for all cores, little enough for a progress bar.
int cpu_block_height(PictureSize size, std::size_t spheres) {
    constexpr double tests_per_block = 3e8;
    const double rows = tests_per_block / (static_cast<double>(size.width) * static_cast<double>(spheres + 1));
    return static_cast<int>(std::clamp(rows, 4.0, static_cast<double>(std::max(4, size.height))));
}

}  // namespace

Image render_picture(OpenBackend& backend, const Scene& scene, const Background& background, PictureSize size,
                     Timings& timings, Progress& progress) {
    Image picture = make_picture(size, background);
    const DrawnSpheres drawn = drawn_spheres(scene);
    if (!backend.gpu) {
        const CpuRenderer cpu(drawn, scene.camera, size);
        for_each_block(scene, background, drawn, picture, size.width, cpu_block_height(size, drawn.center_radius.size()), timings,
                       progress, [&](const Block& block, std::span<std::int32_t> visible) {
                           const PhaseTimer timer(timings, Phase::trace);
                           cpu.trace(block, visible);
                       });
        return picture;
    }
    GpuRenderer& gpu = *backend.gpu;
    if (drawn.center_radius.size() > static_cast<std::size_t>(gpu.sphere_capacity())) {
        throw RenderError("the backend " + backend.description + " holds at most " + std::to_string(gpu.sphere_capacity()) +
                          " spheres in its uniform buffer, the scene has " + std::to_string(drawn.center_radius.size()) +
                          "; use --backend cpu");
    }
    gpu.upload(drawn, scene.camera, size, timings);
    const int side = gpu.largest_block_side();
    for_each_block(scene, background, drawn, picture, side, side, timings, progress,
                   [&](const Block& block, std::span<std::int32_t> visible) { gpu.trace(block, visible, timings); });
    return picture;
}

}  // namespace sphereview

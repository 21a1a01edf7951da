#include "app/render_picture.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "cpu/cpu_renderer.hpp"
#include "shade/shade.hpp"

namespace sphereview {

namespace {

// What happens to each block of a picture after it was traced.
class PictureInProgress {
public:
    PictureInProgress(const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options, Timings& timings,
                      DecisionCounts& counts, Progress& progress)
        : scene_(scene),
          options_(options),
          resolver_(scene, drawn, options.size),
          picture_(make_picture(options.size, options.background)),
          timings_(timings),
          counts_(counts),
          progress_(progress) {}

    // Calls trace(block, visible) for blocks of at most this size, one after the other, and finishes each.
    template <typename Trace>
    Image draw(int block_width, int block_height, const Trace& trace) {
        // Not a vector: nobody needs its millions of numbers cleared first.
        const auto most = static_cast<std::size_t>(std::min(block_width, picture_.width())) *
                          static_cast<std::size_t>(std::min(block_height, picture_.height()));
        const auto buffer = std::make_unique_for_overwrite<std::int32_t[]>(most);
        for (int y = 0; y < picture_.height(); y += block_height) {
            for (int x = 0; x < picture_.width(); x += block_width) {
                const Block block{x, y, std::min(block_width, picture_.width() - x), std::min(block_height, picture_.height() - y)};
                const std::span visible(buffer.get(),
                                        static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
                trace(block, visible);
                finish(block, visible);
            }
        }
        return std::move(picture_);
    }

private:
    void finish(const Block& block, std::span<std::int32_t> visible) {
        const PhaseTimer timer(timings_, Phase::resolve);
        if (options_.certify) {
            counts_ += resolver_.certify(block, visible);
        } else {
            resolver_.accept_guesses(visible);
        }
        shade_flat(scene_, options_.background, block, visible, picture_);
        const double row_part = static_cast<double>(block.x + block.width) / picture_.width();
        progress_.update((block.y + block.height * row_part) / picture_.height());
    }

    const Scene& scene_;
    const PictureOptions& options_;
    Resolver resolver_;
    Image picture_;
    Timings& timings_;
    DecisionCounts& counts_;
    Progress& progress_;
};

// Rows of a CPU block: enough work for all cores, little enough for a progress bar.
int cpu_block_height(PictureSize size, std::size_t spheres) {
    constexpr double tests_per_block = 3e8;
    const double rows = tests_per_block / (static_cast<double>(size.width) * static_cast<double>(spheres + 1));
    return static_cast<int>(std::clamp(rows, 4.0, static_cast<double>(std::max(4, size.height))));
}

}  // namespace

Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, DecisionCounts& counts, Progress& progress) {
    PictureInProgress picture(scene, drawn, options, timings, counts, progress);
    const PictureSize size = options.size;
    if (!backend.gpu) {
        const CpuRenderer cpu(drawn, scene.camera, size);
        return picture.draw(size.width, cpu_block_height(size, drawn.size()),
                            [&](const Block& block, std::span<std::int32_t> visible) {
                                const PhaseTimer timer(timings, Phase::trace);
                                cpu.trace(block, visible);
                            });
    }
    GpuRenderer& gpu = *backend.gpu;
    if (drawn.size() > static_cast<std::size_t>(gpu.sphere_capacity())) {
        throw RenderError("the backend " + backend.description + " holds at most " + std::to_string(gpu.sphere_capacity()) +
                          " spheres in its uniform buffer, the scene has " + std::to_string(drawn.size()) + "; use --backend cpu");
    }
    gpu.upload(drawn, scene.camera, size, timings);
    const int side = gpu.largest_block_side();
    return picture.draw(side, side,
                        [&](const Block& block, std::span<std::int32_t> visible) { gpu.trace(block, visible, timings); });
}

}  // namespace sphereview

// Visibility on the GPU, for an export: scene -> uniform buffer or textures -> trace.frag -> numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/timings.hpp"
#include "exact/drawn.hpp"
#include "exact/visible.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/number_target.hpp"
#include "gpu/scene_tables.hpp"

namespace sphereview {

// Belongs to the context that is current at the construction; use and destroy it only while that is current.
class GpuRenderer {
public:
    // Compiles the shaders (Phase::shaders) and draws one pixel as a test of the context. Throws RenderError.
    explicit GpuRenderer(Timings& timings, const TextureBounds& bounds = {});

    // The number of spheres that fit into the uniform buffer, at least 1,024. More are in textures.
    int uniform_capacity() const { return tables_.uniform_capacity(); }

    // The largest width and height of a block that trace() takes.
    int largest_block_side() const;

    // Uploads what trace() draws. Throws TooLarge, before it uploads anything, if the context cannot hold it.
    void upload(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size, Timings& timings);

    // Where upload() put the spheres: "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const { return tables_.storage(); }

    // Writes, row by row, what each pixel of the block shows (exact/visible.hpp), as indices among the drawn spheres.
    void trace(const Block& block, std::span<std::int32_t> visible, Timings& timings);

private:
    void self_check(Timings& timings);

    SceneTables tables_;
    std::vector<std::string> defines_;  // of the compiled shaders
    Program trace_;
    VertexArray no_vertices_;
    Buffer draw_buffer_;
    NumberTarget visible_;
    DrawBlock draw_block_;
    PixelRange covered_;  // pixels outside show no sphere
};

}  // namespace sphereview

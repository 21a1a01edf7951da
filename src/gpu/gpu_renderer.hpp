// Visibility on the GPU: scene -> uniform buffer or textures -> trace.frag -> numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/error.hpp"
#include "base/timings.hpp"
#include "exact/drawn.hpp"
#include "exact/visible.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/table.hpp"
#include "image/image.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

inline constexpr TileCosts gpu_tile_costs = {.smallest_shift = 1, .candidate = 4.0, .test = 1.0};

// The scene is more than the context can hold; another renderer may.
class TooLarge : public RenderError {
public:
    using RenderError::RenderError;
};

// Belongs to the context that is current when it is made; used and destroyed only while that is current.
class GpuRenderer {
public:
    // Compiles the shaders (Phase::shaders) and draws one pixel to see that the context works. Throws RenderError.
    explicit GpuRenderer(Timings& timings, const TextureBounds& bounds = {});

    // How many spheres the uniform buffer holds: at least 1,024. More are in textures.
    int uniform_capacity() const { return uniform_capacity_; }

    // The largest width and height of a block that trace() takes.
    int largest_block_side() const { return largest_block_side_; }

    // Uploads what trace() draws. Throws TooLarge, before it uploads anything, if the context cannot hold it.
    void upload(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size, Timings& timings);

    // Where upload() put the spheres: "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const;

    // Writes, row by row, what each pixel of the block shows (exact/visible.hpp), as indices among the drawn spheres.
    void trace(const Block& block, std::span<std::int32_t> visible, Timings& timings);

    // Colours the block that was traced last, from (0, 0), as a window shows it, through shade.frag. An RGBA picture.
    Image shade(const Scene& scene, const DrawnSpheres& drawn, const Background& background);

private:
    // Where the spheres and lists are; each place has its own shaders.
    struct Storage {
        bool in_block = true;
        TableLimits tables;
    };

    std::vector<std::string> defines() const;
    void choose_storage(std::size_t spheres, const CandidateLists& lists);
    void self_check(Timings& timings);
    void resize_target(int width, int height);
    void draw_covered(const Block& block);

    int uniform_capacity_ = 0;
    TextureBounds bounds_;
    Storage storage_;
    int largest_block_side_ = 0;
    Program trace_;
    Program shade_;
    VertexArray no_vertices_;
    Buffer frame_buffer_;
    Buffer sphere_buffer_;
    Buffer color_buffer_;
    Table sphere_table_;
    Table color_table_;
    Table candidate_table_;
    Table list_begin_table_;
    Texture visible_texture_;
    Framebuffer visible_target_;
    int target_width_ = 0;
    int target_height_ = 0;
    FrameBlock frame_;
    PixelRange covered_;  // of the picture; the rest shows no sphere
    Block last_block_;
};

}  // namespace sphereview

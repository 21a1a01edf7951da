// Visibility on the GPU: scene -> uniform buffers -> trace.frag -> numbers.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/timings.hpp"
#include "exact/drawn.hpp"
#include "exact/visible.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "image/image.hpp"

namespace sphereview {

// Belongs to the context that is current when it is made; used and destroyed only while that is current.
class GpuRenderer {
public:
    // Compiles the shaders (Phase::shaders) and draws one pixel to see that the context works. Throws RenderError.
    explicit GpuRenderer(Timings& timings);

    // How many spheres the uniform buffer holds: at least 1,024.
    int sphere_capacity() const { return capacity_; }

    // The largest width and height of a block that trace() takes.
    int largest_block_side() const { return largest_block_side_; }

    // Uploads what trace() draws. At most sphere_capacity() spheres.
    void upload(const DrawnSpheres& spheres, const Camera& camera, PictureSize size, Timings& timings);

    // Writes, row by row, what each pixel of the block shows (exact/visible.hpp), as indices among the drawn spheres.
    void trace(const Block& block, std::span<std::int32_t> visible, Timings& timings);

    // Colours the block that was traced last, from (0, 0), as a window shows it, through shade.frag. An RGBA picture.
    Image shade(const Scene& scene, const DrawnSpheres& drawn, const Background& background);

private:
    void self_check(Timings& timings);
    void resize_target(int width, int height);

    int capacity_ = 0;
    int largest_block_side_ = 0;
    Program trace_;
    Program shade_;
    VertexArray no_vertices_;
    Buffer frame_buffer_;
    Buffer sphere_buffer_;
    Buffer color_buffer_;
    Texture visible_texture_;
    Framebuffer visible_target_;
    int target_width_ = 0;
    int target_height_ = 0;
    FrameBlock frame_;
    Block last_block_;
};

}  // namespace sphereview

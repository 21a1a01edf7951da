#include "gpu/gpu_renderer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "gpu/program.hpp"

namespace sphereview {

GpuRenderer::GpuRenderer(Timings& timings, const TextureBounds& bounds) : tables_(bounds) {
    no_vertices_ = VertexArray::make();
    draw_buffer_ = Buffer::make();
    glDisable(GL_DITHER);
    self_check(timings);
}

// A context can be made, and its shaders compiled, and still draw nothing.
void GpuRenderer::self_check(Timings& timings) {
    Scene scene;
    scene.spheres.resize(1);
    constexpr PictureSize size{3, 1};
    const DrawnSpheres drawn = drawn_spheres(scene);
    Timings unreported;
    std::array<std::int32_t, 3> visible{};
    {
        const PhaseTimer timer(timings, Phase::shaders);  // the driver compiles at the first draw
        upload(drawn, build_lists(drawn, scene.camera, size, gpu_tile_costs), scene.camera, size, unreported);
        trace({0, 0, 3, 1}, visible, unreported);
    }
    if (visible != std::array<std::int32_t, 3>{visible_background, 0, visible_background}) {
        throw RenderError("a test picture of one sphere came out wrong");
    }
}

int GpuRenderer::largest_block_side() const { return std::min(visible_.largest_side(), preferred_block_side); }

void GpuRenderer::upload(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size,
                         Timings& timings) {
    const PhaseTimer timer(timings, Phase::prepare);
    std::vector<std::string> defines = tables_.defines_for(spheres, lists);
    if (!trace_ || defines != defines_) {
        shade_ = Program();
        trace_ = make_program("trace.frag", defines);
        defines_ = std::move(defines);
    }
    frame_ = draw_block_of(lists, camera, size);
    covered_ = lists.covered;
    tables_.upload(spheres, lists);
}

void GpuRenderer::trace(const Block& block, std::span<std::int32_t> visible, Timings& timings) {
    assert(block.width <= largest_block_side() && block.height <= largest_block_side());
    const Block in_target{0, 0, block.width, block.height};
    {
        const PhaseTimer timer(timings, Phase::trace);
        visible_.require(block.width, block.height);
        frame_.block_origin = {block.x, block.y};
        upload_draw_block(draw_buffer_, frame_);
        tables_.bind();
        glUseProgram(trace_.name());
        // Elsewhere the background is known.
        const Block covered = common(block, covered_);
        if (covered.width < block.width || covered.height < block.height) {
            visible_.fill(frame_.all_doubtful != 0 ? doubtful_background : visible_background);
        }
        if (covered.width > 0 && covered.height > 0) {
            visible_.draw(no_vertices_, {covered.x - block.x, covered.y - block.y, covered.width, covered.height});
        }
        glFinish();
        check_gl("tracing");
    }
    const PhaseTimer timer(timings, Phase::read_back);
    visible_.read(in_target, visible);
    last_block_ = block;
}

Image GpuRenderer::shade(const Scene& scene, const DrawnSpheres& drawn, const Background& background) {
    if (!shade_) shade_ = make_program("shade.frag", defines_);
    tables_.upload_colors(shown_colors(scene, drawn));
    tables_.bind();
    DrawBlock frame = frame_;
    frame.background = shown_background(background);
    frame.picture_size = {last_block_.width, last_block_.height};
    frame.window_corner = {0, last_block_.height - 1};
    upload_draw_block(draw_buffer_, frame);

    const Texture target_texture = Texture::make();
    glBindTexture(GL_TEXTURE_2D, target_texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, last_block_.width, last_block_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const Framebuffer target = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_texture.name(), 0);

    glUseProgram(shade_.name());
    visible_.bind(TextureUnit::visible_spheres);
    draw_block(no_vertices_, {0, 0, last_block_.width, last_block_.height});

    // Row 0 of the target is the bottom row of the window.
    Image upside_down(last_block_.width, last_block_.height, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, last_block_.width, last_block_.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.bytes().data());
    check_gl("shading");
    Image picture(last_block_.width, last_block_.height, 4);
    for (int y = 0; y < picture.height(); ++y) {
        std::copy_n(upside_down.at(0, picture.height() - 1 - y), static_cast<std::size_t>(picture.width()) * 4, picture.at(0, y));
    }
    return picture;
}

}  // namespace sphereview

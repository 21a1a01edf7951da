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
        trace_ = make_program("trace.frag", defines);
        defines_ = std::move(defines);
    }
    draw_block_ = draw_block_of(lists, camera, size, spheres.scale);
    covered_ = lists.covered;
    tables_.upload(spheres, lists);
}

void GpuRenderer::trace(const Block& block, std::span<std::int32_t> visible, Timings& timings) {
    assert(block.width <= largest_block_side() && block.height <= largest_block_side());
    const Block in_target{0, 0, block.width, block.height};
    {
        const PhaseTimer timer(timings, Phase::trace);
        visible_.require(block.width, block.height);
        draw_block_.block_origin = {block.x, block.y};
        upload_draw_block(draw_buffer_, draw_block_);
        tables_.bind();
        glUseProgram(trace_.name());
        // Elsewhere the background is known.
        const Block covered = common(block, covered_);
        if (covered.width < block.width || covered.height < block.height) {
            visible_.fill(draw_block_.all_doubtful != 0 ? doubtful_background : visible_background);
        }
        if (covered.width > 0 && covered.height > 0) {
            visible_.draw(no_vertices_, {covered.x - block.x, covered.y - block.y, covered.width, covered.height});
        }
        glFinish();
        check_gl("tracing");
    }
    const PhaseTimer timer(timings, Phase::read_back);
    visible_.read(in_target, visible);
}

}  // namespace sphereview

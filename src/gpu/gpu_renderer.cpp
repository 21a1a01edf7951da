#include "gpu/gpu_renderer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "gpu/program.hpp"

namespace sphereview {

namespace {

// Larger pictures are drawn in blocks: a watchdog ends a draw that takes seconds.
constexpr int preferred_block_side = 2048;

void put_into(const Buffer& buffer, BlockBinding binding, const void* data, std::size_t used, std::size_t declared) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.name());
    // The size the shader declares, whatever is used: some drivers refuse to draw from less.
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(declared), nullptr, GL_DYNAMIC_DRAW);
    glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(used), data);
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

void draw_everywhere(const Block& block) {
    glViewport(0, 0, block.width, block.height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

GpuRenderer::GpuRenderer(Timings& timings, const TextureBounds& bounds) : bounds_(bounds) {
    {
        const PhaseTimer timer(timings, Phase::shaders);
        uniform_capacity_ =
            std::min(gl_limit(GL_MAX_UNIFORM_BLOCK_SIZE), largest_uniform_block) / static_cast<int>(sizeof(glm::vec4));
        std::array<GLint, 2> viewport{};
        glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
        largest_block_side_ = std::min({gl_limit(GL_MAX_TEXTURE_SIZE), viewport[0], viewport[1], preferred_block_side});

        no_vertices_ = make_vertex_array();
        frame_buffer_ = make_buffer();
        sphere_buffer_ = make_buffer();
        visible_texture_ = make_texture();
        visible_target_ = make_framebuffer();
        glDisable(GL_DITHER);
    }
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

std::vector<std::string> GpuRenderer::defines() const {
    std::vector<std::string> defines = table_defines(storage_.tables);
    if (storage_.in_block) defines.push_back("SPHERE_CAPACITY " + std::to_string(uniform_capacity_));
    return defines;
}

std::string GpuRenderer::storage() const {
    if (storage_.in_block) return "uniform buffer";
    return storage_.tables.shift ? "2D textures" : "buffer textures";
}

void GpuRenderer::choose_storage(std::size_t spheres, const CandidateLists& lists) {
    Storage storage;
    storage.in_block = spheres <= static_cast<std::size_t>(uniform_capacity_);
    const std::size_t longest = std::max({storage.in_block ? 1 : spheres, lists.candidates.size(), lists.begins.size()}) + 1;
    storage.tables = table_limits(longest, bounds_);
    if (longest > storage.tables.most_texels) {
        throw TooLarge("its textures hold tables of " + in_groups(storage.tables.most_texels) + " elements, the scene's " +
                       in_groups(spheres) + " spheres need " + in_groups(longest));
    }
    const bool same_shaders = storage.in_block == storage_.in_block && storage.tables.shift == storage_.tables.shift;
    storage_ = storage;
    if (trace_ && same_shaders) return;
    shade_ = Program();
    trace_ = make_program("trace.frag", defines());
}

void GpuRenderer::resize_target(int width, int height) {
    if (width <= target_width_ && height <= target_height_) return;
    target_width_ = std::max(width, target_width_);
    target_height_ = std::max(height, target_height_);
    glBindTexture(GL_TEXTURE_2D, visible_texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, target_width_, target_height_, 0, GL_RED_INTEGER, GL_INT, nullptr);
    // An integer texture is complete only without filtering and mipmaps; else texelFetch reads 0, which is a sphere.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, visible_target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, visible_texture_.name(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError("the context cannot draw into 32-bit integers");
    }
    check_gl("making the buffer of visible spheres");
}

void GpuRenderer::upload(const DrawnSpheres& spheres, const CandidateLists& lists, const Camera& camera, PictureSize size,
                         Timings& timings) {
    const PhaseTimer timer(timings, Phase::upload);
    choose_storage(spheres.size(), lists);
    const FloatView view = float_view(camera, size, gpu_unit);
    frame_.forward = glm::vec4(view.rays.forward, 0.0F);
    frame_.right = glm::vec4(view.rays.right, 0.0F);
    frame_.up = glm::vec4(view.rays.up, 0.0F);
    frame_.error_scale = view.error_scale;
    frame_.all_doubtful = view.all_doubtful ? 1 : 0;
    frame_.picture_size = {size.width, size.height};
    // At least one: of a picture without spheres, a single tile with an empty list.
    frame_.level_count = std::max(1, static_cast<std::int32_t>(lists.levels.size()));
    frame_.levels[0] = {30, 0, 0, 0};
    covered_ = lists.covered;
    for (std::size_t i = 0; i < lists.levels.size(); ++i) {
        const TileLevel& level = lists.levels[i];
        frame_.levels[i] = {level.shift, level.across, static_cast<std::int32_t>(level.first), 0};
    }
    if (storage_.in_block) {
        put_into(sphere_buffer_, BlockBinding::spheres, spheres.center_radius.data(), spheres.size() * sizeof(glm::vec4),
                 static_cast<std::size_t>(uniform_capacity_) * sizeof(glm::vec4));
    } else {
        sphere_table_.upload(spheres.center_radius.data(), spheres.size(), TexelKind::vec4, TextureUnit::sphere_table,
                             storage_.tables);
    }
    candidate_table_.upload(lists.candidates.data(), lists.candidates.size(), TexelKind::uint_pair, TextureUnit::candidate_table,
                            storage_.tables);
    list_begin_table_.upload(lists.begins.data(), lists.begins.size(), TexelKind::uint, TextureUnit::list_begin_table,
                             storage_.tables);
    check_gl("uploading the spheres");
}

// Draws where there may be spheres; elsewhere the background is known.
void GpuRenderer::draw_covered(const Block& block) {
    // GL reads four, whatever the format.
    const std::array<GLint, 4> nothing = {frame_.all_doubtful != 0 ? doubtful_background : visible_background, 0, 0, 0};
    const int left = std::max(block.x, covered_.left);
    const int top = std::max(block.y, covered_.top);
    const int right = std::min(block.x + block.width - 1, covered_.right);
    const int bottom = std::min(block.y + block.height - 1, covered_.bottom);
    const bool all =
        left == block.x && top == block.y && right == block.x + block.width - 1 && bottom == block.y + block.height - 1;
    if (!all) glClearBufferiv(GL_COLOR, 0, nothing.data());
    if (right < left || bottom < top) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(left - block.x, top - block.y, right - left + 1, bottom - top + 1);
    draw_everywhere(block);
    glDisable(GL_SCISSOR_TEST);
}

void GpuRenderer::trace(const Block& block, std::span<std::int32_t> visible, Timings& timings) {
    assert(block.width <= largest_block_side_ && block.height <= largest_block_side_);
    assert(visible.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    {
        const PhaseTimer timer(timings, Phase::trace);
        resize_target(block.width, block.height);
        frame_.block_origin = {block.x, block.y};
        put_into(frame_buffer_, BlockBinding::frame, &frame_, sizeof frame_, sizeof frame_);
        glBindFramebuffer(GL_FRAMEBUFFER, visible_target_.name());
        glUseProgram(trace_.name());
        glBindVertexArray(no_vertices_.name());
        draw_covered(block);
        glFinish();
        check_gl("tracing");
    }
    const PhaseTimer timer(timings, Phase::read_back);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, block.width, block.height, GL_RED_INTEGER, GL_INT, visible.data());
    check_gl("reading the visible spheres back");
    last_block_ = block;
}

Image GpuRenderer::shade(const Scene& scene, const DrawnSpheres& drawn, const Background& background) {
    if (!shade_) shade_ = make_program("shade.frag", defines());
    const auto color_of = [&](std::size_t i) { return scene.spheres[static_cast<std::size_t>(drawn.number(i))].color; };
    const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    if (storage_.in_block) {
        std::vector<glm::vec4> colors;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            colors.emplace_back(channel(color_of(i).r), channel(color_of(i).g), channel(color_of(i).b), 1.0F);
        }
        if (!color_buffer_) color_buffer_ = make_buffer();
        put_into(color_buffer_, BlockBinding::colors, colors.data(), colors.size() * sizeof(glm::vec4),
                 static_cast<std::size_t>(uniform_capacity_) * sizeof(glm::vec4));
    } else {
        std::vector<std::array<std::uint8_t, 4>> colors;
        for (std::size_t i = 0; i < drawn.size(); ++i) colors.push_back({color_of(i).r, color_of(i).g, color_of(i).b, 255});
        color_table_.upload(colors.data(), colors.size(), TexelKind::rgba8, TextureUnit::color_table, storage_.tables);
    }
    FrameBlock frame = frame_;
    frame.background = glm::vec4(channel(background.color.r), channel(background.color.g), channel(background.color.b),
                                 background.transparent ? 0.0F : 1.0F);
    frame.picture_size = {last_block_.width, last_block_.height};
    put_into(frame_buffer_, BlockBinding::frame, &frame, sizeof frame, sizeof frame);

    const Texture target_texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, target_texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, last_block_.width, last_block_.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const Framebuffer target = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, target.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_texture.name(), 0);

    glUseProgram(shade_.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, visible_texture_.name());
    glBindVertexArray(no_vertices_.name());
    draw_everywhere(last_block_);

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

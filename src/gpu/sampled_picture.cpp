#include "gpu/sampled_picture.hpp"

#include <algorithm>
#include <bit>
#include <exception>
#include <utility>

#include "base/error.hpp"
#include "gpu/program.hpp"
#include "scene/samples.hpp"

namespace sphereview {

namespace {

constexpr int checkerboard_shift = 3;

// What is read back of a strip stays in the processor's cache; and an input waits for one strip at most.
constexpr int first_strip_height = 64;
constexpr int least_strip_height = 16;
int largest_strip_height(int width) { return std::max(least_strip_height, (1 << 18) / width); }
constexpr double longest_strip = 0.008;  // seconds

}  // namespace

SampledPicture::SampledPicture(const TextureBounds& bounds)
    : tables_(bounds),
      no_vertices_(make_vertex_array()),
      draw_buffer_(make_buffer()),
      sums_(make_texture()),
      sums_framebuffer_(make_framebuffer()) {}

void SampledPicture::discard(Change change) {
    begun_ = false;
    samples_ = 0;
    if (change == Change::shaders) defines_.clear();
    if (change == Change::everything) lists_side_ = side_in_work_ = 0;
}

// Whether the lists are there. Those of many spheres take longer than a person should wait for an answer.
bool SampledPicture::have_lists(const Source& source) {
    constexpr std::size_t at_once = 20'000;
    const int side = sample_side(samples_);
    if (lists_side_ == side) return true;
    if (lists_in_work_.valid()) {
        if (lists_in_work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
        std::future<CandidateLists> made = std::move(lists_in_work_);
        if (side_in_work_ == side) {  // else of another picture
            lists_ = made.get();
            lists_side_ = side;
            return true;
        }
    }
    const auto build = [](const DrawnSpheres& drawn, const Camera& camera, PictureSize size) {
        return build_lists(drawn, camera, size, gpu_tile_costs);
    };
    const PictureSize size = sampled_size(source.size, side);
    if (source.drawn.size() > at_once) {
        side_in_work_ = side;
        lists_in_work_ = std::async(std::launch::async, build, source.drawn, source.camera, size);  // of copies
        return false;
    }
    lists_ = build(source.drawn, source.camera, size);
    lists_side_ = side;
    return true;
}

void SampledPicture::compile(const Source& source) {
    std::vector<std::string> defines = tables_.defines_for(source.drawn, lists_);
    if (!defines_.empty() && defines == defines_) return;
    trace_ = make_program("trace.frag", defines, source.shaders);
    shade_ = make_program(depends_on_hit(source.shading) ? "surface.frag" : "shade.frag", defines, source.shaders);
    defines_ = std::move(defines);
}

void SampledPicture::begin(const Source& source) {
    compile(source);
    tables_.upload(source.drawn, lists_);
    tables_.upload_colors(source.colors);
    const int side = sample_side(samples_);
    frame_ = draw_block_of(lists_, source.camera, sampled_size(source.size, side));
    visible_.require(source.size.width, source.size.height);
    if (!(sums_size_ == source.size)) {
        sums_size_ = {0, 0};  // unless all goes well
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, sums_.name());
        // Half floats would round the sum of 16 points.
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, source.size.width, source.size.height, 0, GL_RGBA, GL_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, sums_framebuffer_.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sums_.name(), 0);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
            throw RenderError("the context cannot draw into 32-bit floats");
        }
        check_gl("making the buffer of colours");
        sums_size_ = source.size;
    }
    point_ = row_ = 0;
    strip_height_ = first_strip_height;
    strip_traced_ = false;
    begun_ = true;
}

Pixel SampledPicture::offset() const {
    const int side = sample_side(samples_);
    return {point_ % side, point_ / side};
}

void SampledPicture::trace_strip(const Source& source, const Block& strip) {
    const int side = sample_side(samples_);
    // Each texel is traced for one point of its pixel: a pixel of the picture that the lists are of.
    DrawBlock frame = frame_;
    frame.grid_shift = std::countr_zero(static_cast<unsigned>(side));
    frame.block_origin = {offset().x, offset().y};
    upload_draw_block(draw_buffer_, frame);
    tables_.bind();
    glUseProgram(trace_.name());
    PixelRange covered;
    if (!lists_.covered.empty()) {
        covered = {lists_.covered.left / side, lists_.covered.top / side, lists_.covered.right / side,
                   lists_.covered.bottom / side};
    }
    // Elsewhere the background is known.
    if (strip.y == 0 && !(covered == PixelRange{0, 0, source.size.width - 1, source.size.height - 1})) {
        visible_.fill(frame.all_doubtful != 0 ? doubtful_background : visible_background);
    }
    for (int x = 0; x < strip.width; x += preferred_block_side) {
        const Block block = common({x, strip.y, std::min(preferred_block_side, strip.width - x), strip.height}, covered);
        if (block.width > 0 && block.height > 0) visible_.draw(no_vertices_, block);
    }
}

// Whether all of it is decided.
bool SampledPicture::decide_strip(const Source& source, const Block& strip, const Deadline& deadline) {
    const int side = sample_side(samples_);
    const Resolver resolver(source.scene, source.drawn, source.camera, sampled_size(source.size, side), &lists_);
    std::vector<std::int32_t> visible(static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height));
    visible_.read(strip, visible);
    const Decided decided = decide_doubtful(
        resolver, source.drawn, visible,
        [&](int place) {
            return Pixel{place % strip.width * side + offset().x, (strip.y + place / strip.width) * side + offset().y};
        },
        deadline);
    if (decided.any) visible_.write(strip, visible);
    return decided.all;
}

void SampledPicture::add_strip(const Source& source, const Block& strip) {
    DrawBlock frame = frame_;
    frame.background = shown_background(background_);
    frame.checkerboard = checkerboard_shift;
    frame.picture_size = {sums_size_.width, sums_size_.height};
    frame.window_corner = {0, sums_size_.height - 1};
    frame.shading = source.shown.shading;
    frame.nearest_depth = source.shown.nearest_depth;
    frame.inverse_depth_range = source.shown.inverse_depth_range;
    frame.axis_right = source.shown.axis_right;
    frame.axis_up = source.shown.axis_up;
    frame.axis_toward = source.shown.axis_toward;
    frame.point_offset = {offset().x, offset().y};
    frame.point_shift = std::countr_zero(static_cast<unsigned>(sample_side(samples_)));
    upload_draw_block(draw_buffer_, frame);
    tables_.bind();
    visible_.bind(TextureUnit::visible_spheres);
    glUseProgram(shade_.name());
    glBindFramebuffer(GL_FRAMEBUFFER, sums_framebuffer_.name());
    if (point_ > 0) {  // the first replaces what was there
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    draw_block(no_vertices_, {0, sums_size_.height - strip.y - strip.height, strip.width, strip.height});
    glDisable(GL_BLEND);
    glFinish();  // the time is known
    check_gl("adding up the points of pixels");
}

void SampledPicture::refine(const Source& source, int samples, const Background& background, double seconds) {
    if (finished(samples, background)) return;
    const Deadline deadline(seconds);
    if (!is_of(samples, background)) begun_ = impossible_ = false;
    samples_ = samples;
    background_ = background;
    try {
        if (!begun_) {
            point_ = row_ = 0;
            if (!have_lists(source)) return;
            begin(source);
            if (deadline.passed()) return;  // uploading a million spheres is enough for once
        }
        do {
            const Block strip{0, row_, source.size.width, std::min(strip_height_, source.size.height - row_)};
            const auto strip_begin = std::chrono::steady_clock::now();
            if (!strip_traced_) trace_strip(source, strip);
            strip_traced_ = true;
            if (!decide_strip(source, strip, deadline)) return;
            add_strip(source, strip);
            strip_traced_ = false;
            row_ += strip.height;
            const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - strip_begin).count();
            if (taken > longest_strip) strip_height_ = std::max(strip_height_ / 2, least_strip_height);
            if (taken < 0.25 * longest_strip) strip_height_ = std::min(strip_height_ * 2, largest_strip_height(source.size.width));
            if (row_ == source.size.height) {
                row_ = 0;
                ++point_;
            }
        } while (point_ < samples_ && !deadline.passed());
    } catch (const std::exception&) {  // too large, not supported, no memory: the picture without samples is there
        impossible_ = true;
    }
}

void SampledPicture::draw(const Program& average, const VertexArray& no_vertices, const Block& area) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::sums));
    glBindTexture(GL_TEXTURE_2D, sums_.name());
    glActiveTexture(GL_TEXTURE0);
    glUseProgram(average.name());
    glUniform1i(glGetUniformLocation(average.name(), "samples"), samples_);
    draw_block(no_vertices, area);
}

}  // namespace sphereview

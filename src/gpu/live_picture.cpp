#include "gpu/live_picture.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "gpu/kept_framebuffers.hpp"
#include "gpu/picture_texture.hpp"
#include "light/light_set.hpp"
#include "scene/vectors.hpp"
#include "tiles/pixel_range.hpp"

namespace sphereview {

namespace {

constexpr std::int32_t checkerboard_shift = 3;  // squares of 8 pixels
constexpr std::size_t most_single_ranges = 4096;
// With more spheres a coarse grid has lists of its own. Those of fewer are quickly made for all pixels, once and for all grids.
constexpr std::size_t most_for_all_pixels = 20'000;
constexpr double part_seconds = 0.008;  // of drawing, before somebody may ask for something else

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void set_grid(DrawBlock& block, int step) {
    block.grid_shift = PixelGrid({}, step).shift();
    block.block_origin = {step / 2, step / 2};
}

// Numbers and flat colours are to arrive as they are written.
void draw_plainly() {
    for (const GLenum what : {GL_DITHER, GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_FRAMEBUFFER_SRGB,
                              GL_COLOR_LOGIC_OP, GL_SCISSOR_TEST, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_RASTERIZER_DISCARD}) {
        glDisable(what);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void fill(const WindowArea& area, const glm::vec4& color) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
    glClearBufferfv(GL_COLOR, 0, &color.x);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

LivePicture::Programs LivePicture::make_programs(const ShaderFiles& files, std::vector<std::string> defines) {
    for (std::size_t mode = 0; mode < shading_modes.size(); ++mode)
        defines.push_back("shading_" + std::string(shading_modes.at(mode).name) + " " + std::to_string(mode));
    std::vector<std::string> coarse = defines;
    coarse.emplace_back("COARSE");
    return {make_program("trace.frag", defines, files),
            make_program("shade.frag", defines, files),
            make_program("shade.frag", coarse, files),
            make_program("image.frag", defines, files),
            make_program("surface.frag", defines, files),
            make_program("surface.frag", coarse, files),
            {make_program("mark.frag", defines, files), make_program("mark.frag", coarse, files),
             make_program("busy.frag", defines, files), make_program("outline.frag", defines, files)}};
}

LivePicture::LivePicture(const std::string& shader_folder, const TextureBounds& bounds)
    : shader_folder_(shader_folder),
      no_vertices_(VertexArray::make()),
      draw_buffer_(Buffer::make()),
      tables_(bounds, LiveLists::most_changes) {
    if (!shader_folder_.empty()) shader_files_ = ShaderFiles(shader_folder_);
    compile(tables_.defines_for(scene_.drawn(), scene_.lists()));
}

// Where the folder's shaders fail, perhaps only with these defines, the program's own do.
void LivePicture::compile(const std::vector<std::string>& defines) {
    try {
        programs_ = make_programs(shader_files_, defines);
    } catch (const RenderError& error) {
        if (shader_folder_.empty()) throw;
        shader_log_ = error.what();
        shader_files_ = ShaderFiles();
        programs_ = make_programs(shader_files_, defines);
    }
    defines_ = defines;
    compiled_ = false;
}

std::string LivePicture::reload_shaders() {
    if (shader_folder_.empty()) return "";
    try {
        ShaderFiles files(shader_folder_);
        programs_ = make_programs(files, defines_);
        shader_files_ = std::move(files);
        shader_log_.clear();
        traced_ = compiled_ = false;
        next_step_ = 0;
    } catch (const std::runtime_error& error) {  // RenderError, InputError, MemoryError
        shader_log_ = error.what();
    }
    return shader_log_;
}

void LivePicture::rebuild(const Document& document, const View& view, bool geometry, int step, bool keeps_picture) {
    const Scene& scene = document.scene();
    std::optional<DrawnSpheres> drawn;
    const bool anew = geometry || scene_.edited();
    if (anew) {
        drawn = drawn_spheres(scene, view.camera);
    } else if (!same_eye(view.camera, view_.camera)) {
        drawn = drawn_again(scene, view.camera, scene_.drawn());
    }
    const DrawnSpheres& spheres = drawn ? *drawn : scene_.drawn();
    const PixelGrid grid{view.size, spheres.size() > most_for_all_pixels ? step : 1};
    CandidateLists built = build_lists(spheres, view.camera, grid, gpu_tile_costs, EditedLists::spare(grid));
    EditedLists lists = tables_.take_edits_of(spheres) ? EditedLists(std::move(built), view.camera, grid, spheres.scale)
                                                       : EditedLists(std::move(built));
    const std::vector<std::string> defines = tables_.defines_for(spheres, lists.lists());
    if (defines != defines_) compile(defines);

    ++builds_;
    if (keeps_picture) {
        revision_ = 0;  // unless the upload goes well
        next_step_ = 0;
    } else {
        forget_picture();
    }
    tables_.upload(spheres, lists.lists());
    draw_block_ = draw_block_of(lists.lists(), view.camera, view.size, spheres.scale);
    if (keeps_picture) set_grid(draw_block_, step_);
    lists_step_ = grid.step;
    view_ = view;
    if (drawn) {
        scene_ = LiveLists(std::move(*drawn), std::move(lists), view.camera);
    } else {
        scene_.replace_lists(std::move(lists), view.camera);
    }
    if (anew) colors_.set(scene, scene_.drawn(), shading_);
}

// Brings what was built up to date in proportion to what changed; false where it must be built anew.
bool LivePicture::follow(const Document& document, const ChangesSince& changes) {
    if (!scene_.follow(document.scene(), changes)) return false;
    forget_picture();
    tables_.update(scene_.drawn(), scene_.lists(), scene_.take_changed());
    draw_block_ = draw_block_of(scene_.lists(), view_.camera, view_.size, scene_.drawn().scale);
    colors_.follow(document.scene(), scene_.drawn(), shading_, changes.spheres, changes.order);
    return true;
}

void LivePicture::forget_picture() {
    revision_ = 0;  // unless all goes well, nothing here fits together
    step_ = 0;
    range_.reset();
    selected_range_known_ = false;
    traced_ = false;
    next_step_ = 0;
}

void LivePicture::begin_trace(int step) {
    const PixelGrid grid{view_.size, step};
    const auto [width, height] = grid.size();
    next_visible_.require(width, height);
    PixelRange covered;
    if (const PixelRange& pixels = scene_.lists().covered; !pixels.empty()) {
        covered = {pixels.left / step, pixels.top / step, pixels.right / step, pixels.bottom / step};
    }
    // Elsewhere the background is known.
    if (!(covered == PixelRange{0, 0, width - 1, height - 1})) {
        next_visible_.fill(draw_block_.all_doubtful != 0 ? doubtful_background : visible_background);
    }
    next_parts_ = PictureParts(scene_.lists(), grid, covered);
    next_step_ = step;
    next_seconds_ = next_drawing_seconds_ = 0.0;
}

// Goes on with the picture. Returns whether that is there now: not if there is a coarser one and patience has ended, or if it would
// take too long and there is none.
bool LivePicture::trace(int step, double patience) {
    if (next_step_ != step) begin_trace(step);
    DrawBlock of_grid = draw_block_;
    set_grid(of_grid, step);
    upload_draw_block(draw_buffer_, of_grid);
    tables_.bind();
    glUseProgram(programs_.trace.name());
    double drawing = 0.0;  // seconds, in this call
    while (!next_parts_.ended()) {
        const auto [block, cost] = next_parts_.take(scene_.lists(), part_cost_);
        // Drivers compile a program when it first draws. What that takes says nothing of the parts.
        if (!std::exchange(compiled_, true)) {
            next_visible_.draw(no_vertices_, {block.x, block.y, 1, 1});
            glFinish();
        }
        const auto begin = std::chrono::steady_clock::now();
        next_visible_.draw(no_vertices_, block);
        glFinish();  // no draw waits behind another; and the time is known
        const double seconds = std::max(seconds_since(begin), 1e-9);
        drawing += seconds;
        next_drawing_seconds_ += seconds;
        // The last part of a picture may be too small to say anything.
        if (seconds > part_seconds || 2.0 * cost > part_cost_) {
            part_cost_ = std::max(cost * std::clamp(part_seconds / seconds, 0.1, 4.0), least_part_cost);
        }
        if (next_parts_.ended()) break;
        if (traced_ && drawing > patience) return false;
        if (!traced_ && step < coarsest_step && whole_drawing_seconds() > 2.0 * patience) return false;
    }
    check_gl("tracing");
    std::swap(visible_, next_visible_);
    set_grid(draw_block_, step);
    traced_ = true;
    step_ = step;
    next_step_ = 0;
    return true;
}

// What all of the picture's parts will have taken, as far as those that are drawn can tell.
double LivePicture::whole_drawing_seconds() const {
    return next_drawing_seconds_ * next_parts_.cost() / (next_parts_.cost() - next_parts_.cost_left());
}

// For show(), which is not given the scene.
void LivePicture::prepare_shading(const Document& document, Shading shading, const Light& light) {
    const Scene& scene = document.scene();
    if ((shading == Shading::id) != (shading_ == Shading::id)) colors_.set(scene, scene_.drawn(), shading);
    shading_ = shading;
    if (!depends_on_hit(shading)) return;
    if (!range_) range_ = depth_range(scene, view_.camera);
    // Distances as sphere_at() has them. A float holds none beyond 2^100: where the scene has such, all that it holds is as near.
    const auto scaled = [&](double distance) { return std::ldexp(distance / shading_scale, scene_.drawn().scale); };
    const double range = std::max(scaled(range_->farthest - range_->nearest), 0x1p-100);
    const CameraAxes axes = camera_axes(view_.camera);
    draw_block_.shading = static_cast<std::int32_t>(shading);
    draw_block_.nearest_depth = static_cast<float>(std::min(scaled(range_->nearest), 0x1p100));
    draw_block_.inverse_depth_range = static_cast<float>(1.0 / std::min(range, 0x1p120));
    draw_block_.axis_right = glm::vec4(glm::vec3(axes.right), 0.0F);
    draw_block_.axis_up = glm::vec4(glm::vec3(axes.up), 0.0F);
    draw_block_.axis_toward = glm::vec4(glm::vec3(-axes.ahead), 0.0F);
    draw_block_.key_light = glm::vec4(glm::vec3(key_direction(axes)), static_cast<float>(sky_of(light)));
    const glm::dvec3 sun = light.sun ? sun_strength_of(light) * unit(light.sun->direction) : glm::dvec3(0.0);
    draw_block_.sun_light = glm::vec4(glm::vec3(sun), static_cast<float>(light.key));
}

bool LivePicture::update(const Document& document, const View& view, int step, Shading shading, const std::optional<Light>& light,
                         double patience) {
    assert(std::has_single_bit(static_cast<unsigned>(step)) && view.size.width >= 1 && view.size.height >= 1);
    const auto begin = std::chrono::steady_clock::now();
    if (view.size.width > visible_.largest_side() || view.size.height > visible_.largest_side()) {
        throw TooLarge("its pictures have at most " + in_groups(static_cast<std::uint64_t>(visible_.largest_side())) +
                       " pixels a side");
    }
    const ChangesSince changes = document.changes_since(revision_);
    const bool geometry = revision_ == 0 || changes.order || changes.geometry;
    const bool other_view = view != view_;
    const bool other_grid = (!traced_ || step < step_) && lists_step_ != 1 && lists_step_ != step;
    const bool followed = geometry && revision_ != 0 && !other_view && !other_grid && follow(document, changes);
    if (!followed && (geometry || other_view || other_grid)) {
        const bool keeps_picture = traced_ && !geometry && !other_view && !scene_.edited();
        rebuild(document, view, geometry, step, keeps_picture);
    }
    if (!geometry) colors_.follow(document.scene(), scene_.drawn(), shading_, changes.spheres, false);
    revision_ = document.revision();
    const Light shown_light = light.value_or(document.scene().light);
    prepare_shading(document, shading, shown_light);
    const bool finer_begun = next_step_ != 0 && next_step_ < step;
    if (traced_ && (step >= step_ || finer_begun)) return false;

    const KeptFramebuffers kept;
    draw_plainly();
    while (!trace(step, patience)) {
        if (traced_) {
            next_seconds_ += seconds_since(begin);
            return false;
        }
        // Too fine.
        double drawing = whole_drawing_seconds();
        do {
            step *= 2;
            drawing *= 0.25;
        } while (step < coarsest_step && drawing > patience);
        if (lists_step_ != 1) {
            rebuild(document, view, false, step, false);
            revision_ = document.revision();
            prepare_shading(document, shading, shown_light);
        }
    }
    last_seconds_ = next_seconds_ + seconds_since(begin);
    last_drawing_seconds_ = next_drawing_seconds_;
    return true;
}

void LivePicture::upload(const Image& finished) { sphereview::upload(finished, finished_); }

// Also finds out where they are, and uploads the colours.
void LivePicture::mark_selected(const Selection* selection) {
    static const std::vector<std::uint32_t> none;
    const std::vector<std::uint32_t>& numbers = selection != nullptr ? selection->numbers() : none;
    if (!selected_range_known_ || !colors_.are_marked(numbers)) {
        const bool many = numbers.size() > most_single_ranges;
        selected_range_ = many ? scene_.lists().covered : PixelRange{};
        const PixelPlanes planes(view_.camera, view_.size, scene_.drawn().scale);
        for (std::size_t i = 0; i < numbers.size() && !many; ++i) {
            const auto index = scene_.drawn().index_of(numbers[i]);
            if (index) selected_range_ = united(selected_range_, planes.range(scene_.drawn().center_radius[*index]));
        }
        selected_range_known_ = true;
    }
    colors_.mark(numbers, scene_.drawn());
    colors_.upload(tables_);
}

void LivePicture::show(const WindowArea& area, const Background& background, const Highlights& highlights, bool finished) {
    if (area.width <= 0 || area.height <= 0) return;
    const KeptFramebuffers kept;
    draw_plainly();
    if (step_ == 0) {
        fill(area, shown_background(background));
        return;
    }
    mark_selected(highlights.selection);
    PixelRange outlined = selected_range_;
    DrawBlock block = draw_block_;
    if (const auto index = highlights.hovered ? scene_.drawn().index_of(*highlights.hovered) : std::nullopt) {
        block.hovered = static_cast<std::int32_t>(*index);
        const PixelPlanes planes(view_.camera, view_.size, scene_.drawn().scale);
        outlined = united(outlined, planes.range(scene_.drawn().center_radius[*index]));
    }
    block.background = shown_background(background);
    block.checkerboard = checkerboard_shift;
    block.window_corner = {area.x, area.y + area.height - 1};
    block.outline = std::max(highlights.thickness, 1.0F);
    upload_draw_block(draw_buffer_, block);
    tables_.bind();
    const Block whole{area.x, area.y, area.width, area.height};
    if (finished) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::image));
        glBindTexture(GL_TEXTURE_2D, finished_.name());
        glActiveTexture(GL_TEXTURE0);
        glUseProgram(programs_.image.name());
    } else {
        visible_.bind(TextureUnit::visible_spheres);
        const bool coarse = step_ > 1;
        const Program& surface = coarse ? programs_.coarse_surface : programs_.surface;
        const Program& shade = coarse ? programs_.coarse_shade : programs_.shade;
        glUseProgram(depends_on_hit(shading_) ? surface.name() : shade.name());
    }
    draw_block(no_vertices_, whole);
    outlines_.draw(programs_.outlines, no_vertices_, visible_, block, outlined, area, kept.draw());
    check_gl("showing the picture");
}

}  // namespace sphereview

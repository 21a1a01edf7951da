// The picture of a scene in a window, while the scene is edited and the view moves.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "edit/document.hpp"
#include "edit/selection.hpp"
#include "exact/explain.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/number_target.hpp"
#include "gpu/outlines.hpp"
#include "gpu/program.hpp"
#include "gpu/scene_tables.hpp"
#include "gpu/shown_colors.hpp"
#include "image/image.hpp"
#include "light/explain_light.hpp"
#include "shade/picture_shader.hpp"
#include "shade/shading.hpp"
#include "tiles/live_lists.hpp"
#include "tiles/picture_parts.hpp"

namespace sphereview {

// The camera and the size of a picture.
struct View {
    Camera camera;
    PictureSize size;  // in the window's framebuffer pixels

    bool operator==(const View&) const = default;
};

// The spheres that get outlines.
struct Highlights {
    const Selection* selection = nullptr;
    std::optional<std::uint32_t> hovered;
    float thickness = 2.0F;  // of a selected sphere's line in pixels, at least 1, without rims; half for a hovered one
};

// The spheres that a picture's traced pixels show: numbers or visible_background; best guesses for doubtful pixels.
struct SeenTexels {
    int step = 1;   // every step-th pixel of each row and column is traced
    int width = 0;  // texels in a row
    std::vector<std::int32_t> numbers{};
};

// Belongs to the current context, like GpuRenderer. Decides alone what to upload and what to trace again. Others may draw in the
// same context in between. update(), show() and pick() keep the bound framebuffers, but change program, textures, viewport and
// uniform buffers, and turn blending, tests and masks off.
class LivePicture {
public:
    // Compiles the shaders, from `shader_folder` if it is not empty; if these do not compile, the program's own, and shader_log()
    // says why. Throws InputError when the folder cannot be read, and RenderError. `bounds`: for tests.
    explicit LivePicture(const std::string& shader_folder = "", const TextureBounds& bounds = {});

    // Brings the picture up to date: traces every step-th pixel of each row and column, unless the picture is of this scene and
    // view and as fine. `step`: a power of two; pixels between show the spheres traced around them. Returns whether the picture has
    // changed. Throws TooLarge and RenderError, and then keeps the former picture. `shading`: for show(); a change needs no
    // tracing. `light`: replaces the scene's. `patience`: seconds for drawing. A picture that would take more than twice as long is
    // traced coarser, up to coarsest_step, if there is none of this scene and view yet; else the coarser one stays, and each call
    // draws a part of the finer one.
    bool update(const Document& document, const View& view, int step, Shading shading = Shading::flat,
                const std::optional<Light>& light = {}, double patience = std::numeric_limits<double>::infinity());

    static constexpr int coarsest_step = 32;

    // Uploads another renderer's finished picture for show(). At most as large as the context's textures.
    void upload(const Image& finished);

    // The seconds that the present picture took: lists, uploads and drawing.
    double last_seconds() const { return last_seconds_; }
    // The drawing's part of these.
    double last_drawing_seconds() const { return last_drawing_seconds_; }
    // The present picture's step; 0 before the first.
    int step() const { return step_; }

    // Colours the picture into the bound framebuffer, with outlines. A transparent background shows as a checkerboard. Parts of the
    // area outside the picture show the picture's edge; before the first picture all shows the background. `finished`: shows the
    // uploaded picture, of the same size, instead of the traced one, with the traced one's outlines.
    void show(const WindowArea& area, const Background& background, const Highlights& highlights, bool finished = false);

    // The number of the sphere that a pixel shows, or visible_background, also outside the picture. Read from the visible-sphere
    // buffer; decided on the CPU for a doubtful pixel and one that was not traced itself. For the present document, with the last
    // update()'s view.
    std::int32_t pick(const Document& document, Pixel pixel);

    // The spheres that the pixels of a fine picture show, row by row: numbers or visible_background, guesses marked. Empty while
    // the picture is coarse.
    std::vector<std::int32_t> seen_numbers() const;

    // The same for traced pixels of a picture that may be coarse, with guesses for doubtful ones; empty before the first picture.
    SeenTexels seen_texels() const;

    // The arithmetic of a pixel, for the present document and the last update()'s view. In a fine picture tries only the spheres in
    // the pixel's lists, unless passed spheres are asked for (see explain_pixel()).
    PixelExplanation explain(const Document& document, Pixel pixel, std::size_t most_passed) const;

    // The number of spheres that explain() may have to compare.
    std::size_t candidates(const Document& document, Pixel pixel) const;

    // The lights on a pixel that shows the sphere `visible`, for the same document and view. `most_lines`: as for explain_lights().
    PixelLights explain_lights(const Document& document, Pixel pixel, std::int32_t visible, const NumberedLights& lights,
                               std::size_t most_lines) const;

    // Reads the shaders in the folder again; the next update() traces with them. If they do not compile, the last good ones stay.
    // Returns the log, with file and line, or "" when all is well.
    std::string reload_shaders();
    // The log of the last attempt to compile the folder's shaders; "" when all is well.
    const std::string& shader_log() const { return shader_log_; }

    // "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const { return tables_.storage(); }
    // How often drawn spheres and lists were built from nothing, instead of following edits of few spheres.
    std::uint64_t builds() const { return builds_; }

private:
    struct Programs {
        Program trace;
        Program shade;
        Program coarse_shade;  // of coarse pictures
        Program image;
        Program surface;
        Program coarse_surface;
        OutlinePrograms outlines;
    };
    static Programs make_programs(const ShaderFiles& files, std::vector<std::string> defines);

    void compile(const std::vector<std::string>& defines);
    // Makes the lists anew. `keeps_picture`: the traced picture is of the same spheres and view, and stays.
    void rebuild(const Document& document, const View& view, bool geometry, int step, bool keeps_picture);
    bool follow(const Document& document, const ChangesSince& changes);
    void forget_picture();
    void begin_trace(int step);
    bool trace(int step, double patience);
    double whole_drawing_seconds() const;
    void prepare_shading(const Document& document, Shading shading, const Light& light);
    void mark_selected(const Selection* selection);
    std::optional<std::int32_t> traced_number(Pixel pixel) const;
    // The indices of the drawn spheres in the picture's grid, row by row.
    std::vector<std::int32_t> traced_indices() const;
    std::int32_t number_of(std::int32_t index) const;
    bool is_of(const Document& document) const;
    // Lists of a grid know nothing of other pixels.
    const CandidateLists* lists_for_any_pixel() const { return lists_step_ == 1 ? &scene_.lists() : nullptr; }

    std::string shader_folder_;
    ShaderFiles shader_files_;  // the last good ones
    std::string shader_log_;
    std::vector<std::string> defines_;  // of the compiled programs
    Programs programs_;
    VertexArray no_vertices_;
    Buffer draw_buffer_;
    SceneTables tables_;
    NumberTarget visible_;
    NumberTarget next_visible_;  // for the picture that is being traced
    Outlines outlines_;
    Texture finished_;

    std::uint64_t revision_ = 0;  // of the document that all below is made from; 0: none
    View view_;
    LiveLists scene_;  // the drawn spheres and their lists
    std::uint64_t builds_ = 0;
    int lists_step_ = 1;  // the lists hold for the grid with this step; 1: for all pixels
    DrawBlock draw_block_;

    Shading shading_ = Shading::flat;
    std::optional<DepthRange> range_;  // of this scene and eye, once needed
    ShownColors colors_;
    PixelRange selected_range_;          // pixels outside show no marked sphere
    bool selected_range_known_ = false;  // for this scene and view

    bool traced_ = false;  // the visible-sphere buffer is of this scene, view and shaders
    int step_ = 0;

    // The picture that is being traced.
    int next_step_ = 0;  // 0: none is
    PictureParts next_parts_;
    double next_seconds_ = 0.0;  // that it has taken
    double next_drawing_seconds_ = 0.0;
    bool compiled_ = false;   // the program has drawn: the driver has compiled it
    double part_cost_ = 2e6;  // so that a part takes about 0.01 s; the first value takes little on any device
    static constexpr double least_part_cost = 1e4;

    double last_seconds_ = 0.0;
    double last_drawing_seconds_ = 0.0;
};

}  // namespace sphereview

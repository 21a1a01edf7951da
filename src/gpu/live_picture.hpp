// The picture of a scene that is being edited and moved about, drawn into a window again and again.
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

// What a picture shows.
struct View {
    Camera camera;
    PictureSize size;  // in the window's framebuffer pixels

    bool operator==(const View&) const = default;
};

// What is marked by an outline.
struct Highlights {
    const Selection* selection = nullptr;
    std::optional<std::uint32_t> hovered;
    float thickness = 2.0F;  // of a selected sphere's line, in pixels, at least 1, without its rims; a hovered one's is half
};

// What the traced pixels of a picture show: numbers of the scene's spheres, or visible_background; where float could not tell, the
// best guess.
struct SeenTexels {
    int step = 1;   // every step-th pixel of each row and column is traced
    int width = 0;  // texels in a row
    std::vector<std::int32_t> numbers{};
};

// Belongs to the current context, like GpuRenderer. It alone decides what to upload and whether anything must be traced again.
// Others may draw in the same context in between. update(), show() and pick() leave the bound framebuffers as they were; the
// program, the textures, the viewport and the uniform buffers not; blending, tests and masks are off.
class LivePicture {
public:
    // Compiles the shaders, from `shader_folder` if it is not empty; if those do not compile, the program's own, and
    // shader_log() says why. Throws InputError when the folder cannot be read, RenderError. `bounds` are for tests.
    explicit LivePicture(const std::string& shader_folder = "", const TextureBounds& bounds = {});

    // Brings the picture up to date: traces every step-th pixel of each row and column (a power of two; the pixels between show
    // what is traced around them), if what is there is coarser than that or of another scene or view. With step 1 all pixels.
    // Returns whether there is another picture now. Throws TooLarge, RenderError; the picture is then what it was. `shading` is
    // what show() will colour it by; another one needs no tracing. `light` is instead of the scene's.
    // `patience`: seconds for drawing. What would take more than twice as long is traced coarser, by up to coarsest_step, if there
    // is no picture of this scene and view; if there is a coarser one, it stays, and a call for each part goes on with the finer
    // one.
    bool update(const Document& document, const View& view, int step, Shading shading = Shading::flat,
                const std::optional<Light>& light = {}, double patience = std::numeric_limits<double>::infinity());

    static constexpr int coarsest_step = 32;

    // Uploads a picture that another renderer has finished, for show(). No larger than the context's textures.
    void upload(const Image& finished);

    // How long the picture that is there took, in seconds: the lists, the uploads, and drawing until it was done.
    double last_seconds() const { return last_seconds_; }
    // What of it was the drawing.
    double last_drawing_seconds() const { return last_drawing_seconds_; }
    // Of the picture that is there; 0 before the first.
    int step() const { return step_; }

    // Colours the picture into the bound framebuffer and draws the outlines over it. A transparent background shows as a
    // checkerboard. What of the area is beyond the picture shows the picture's edge. Before the first picture: the background.
    // `finished`: the picture uploaded last, which must be of the same size, instead of the traced one; the outlines are that
    // one's.
    void show(const WindowArea& area, const Background& background, const Highlights& highlights, bool finished = false);

    // The number of the sphere that a pixel of the picture shows, or visible_background, also outside the picture. From the
    // visible-sphere buffer where that is sure; a pixel that is doubtful, or that was not traced itself, is decided on the CPU.
    // Of the document as it is now, seen as in the last update().
    std::int32_t pick(const Document& document, Pixel pixel);

    // What every pixel of a fine picture shows, row by row: numbers of the document's spheres, or visible_background; guesses are
    // marked. Nothing while the picture is coarse.
    std::vector<std::int32_t> seen_numbers() const;

    // The same of a picture that may be coarse, with guesses for what is doubtful; none before the first.
    SeenTexels seen_texels() const;

    // The arithmetic of a pixel in the picture, of the document as it is now, seen as in the last update(). Of a fine picture it
    // tries only the spheres in the pixel's lists, unless some are asked for that the ray passes (see explain_pixel()).
    PixelExplanation explain(const Document& document, Pixel pixel, std::size_t most_passed) const;

    // How many spheres explain() may have to compare.
    std::size_t candidates(const Document& document, Pixel pixel) const;

    // The lights on a pixel in the picture, which shows that sphere; of the same document and view. `most_lines`: as
    // explain_lights() takes it.
    PixelLights explain_lights(const Document& document, Pixel pixel, std::int32_t visible, const NumberedLights& lights,
                               std::size_t most_lines) const;

    // Reads the shaders in the folder again; the next update() traces with them. What does not compile leaves the last good
    // ones running. Returns the log, naming file and line, or "" when all is well.
    std::string reload_shaders();
    // What the last attempt to compile the folder's shaders had to say; "" when all is well.
    const std::string& shader_log() const { return shader_log_; }

    // "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const { return tables_.storage(); }
    // How often the drawn spheres and the lists were built from nothing. Edits of a few of many spheres are followed instead.
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
    // Makes the lists anew. `keeps_picture`: what is traced is of the same spheres and view, and stays.
    void rebuild(const Document& document, const View& view, bool geometry, int step, bool keeps_picture);
    bool follow(const Document& document, const ChangesSince& changes);
    void forget_picture();
    void begin_trace(int step);
    bool trace(int step, double patience);
    double whole_drawing_seconds() const;
    void prepare_shading(const Document& document, Shading shading, const Light& light);
    void mark_selected(const Selection* selection);
    std::optional<std::int32_t> traced_number(Pixel pixel) const;
    // Of the picture's grid, row by row: indices among the drawn spheres.
    std::vector<std::int32_t> traced_indices() const;
    std::int32_t number_of(std::int32_t index) const;
    bool is_of(const Document& document) const;
    // Lists of a grid know nothing of other pixels.
    const CandidateLists* lists_for_any_pixel() const { return lists_step_ == 1 ? &scene_.lists() : nullptr; }

    std::string shader_folder_;
    ShaderFiles shader_files_;  // the last good ones
    std::string shader_log_;
    std::vector<std::string> defines_;  // that the programs were compiled with
    Programs programs_;
    VertexArray no_vertices_;
    Buffer draw_buffer_;
    SceneTables tables_;
    NumberTarget visible_;
    NumberTarget next_visible_;  // of the picture that is being traced
    Outlines outlines_;
    Texture finished_;

    std::uint64_t revision_ = 0;  // that all below is made from; 0: none
    View view_;
    LiveLists scene_;  // the drawn spheres and their lists
    std::uint64_t builds_ = 0;
    int lists_step_ = 1;  // they are for the pixels of the grid with this step alone; 1: for all
    DrawBlock draw_block_;

    Shading shading_ = Shading::flat;
    std::optional<DepthRange> range_;  // of this scene and eye, once it was needed
    ShownColors colors_;
    PixelRange selected_range_;          // outside it no pixel shows a sphere that is marked in the colours
    bool selected_range_known_ = false;  // it is of this scene and view

    bool traced_ = false;  // the visible-sphere buffer is of this scene, view and shaders
    int step_ = 0;

    // The picture that is being traced.
    int next_step_ = 0;  // 0: none is
    PictureParts next_parts_;
    double next_seconds_ = 0.0;  // that it has taken
    double next_drawing_seconds_ = 0.0;
    bool compiled_ = false;   // the program has drawn: the driver has compiled it
    double part_cost_ = 2e6;  // such that a part takes about a hundredth of a second; the first one takes little on any device
    static constexpr double least_part_cost = 1e4;

    double last_seconds_ = 0.0;
    double last_drawing_seconds_ = 0.0;
};

}  // namespace sphereview

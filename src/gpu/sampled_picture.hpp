// A window's picture with several points a pixel, made little by little while nothing changes.
#pragma once

#include <cstdint>
#include <future>
#include <span>
#include <string>
#include <vector>

#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "gpu/decide_doubtful.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/number_target.hpp"
#include "gpu/scene_tables.hpp"
#include "gpu/shader_source.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"

namespace sphereview {

// Belongs to the current context, like the LivePicture that owns it. The points of all pixels with the same place in their pixel
// are a picture of the window's size: traced, decided as for an export, coloured by shade.frag and added up, one such picture
// after the other, in strips. So the window shows the average that an export has (image/average.hpp).
class SampledPicture {
public:
    // What is shown; it must stay the same until discard().
    struct Source {
        const Scene& scene;
        const DrawnSpheres& drawn;
        const Camera& camera;
        PictureSize size;
        std::span<const ShownColor> colors;
        const ShaderFiles& shaders;
        Shading shading;
        const DrawBlock& shown;  // the window's: how it is shaded
    };

    explicit SampledPicture(const TextureBounds& bounds = {});

    enum class Change { colors, shaders, everything };
    // What was made is of another picture now; the next refine() begins anew.
    void discard(Change change);

    // Goes on for about so many seconds. Draws, and leaves the program, textures and uniform buffers changed, blending off.
    void refine(const Source& source, int samples, const Background& background, double seconds);

    // The average is there.
    bool complete(int samples, const Background& background) const { return is_of(samples, background) && point_ == samples_; }
    // refine() has nothing to do: complete, or the context cannot do it.
    bool finished(int samples, const Background& background) const {
        return is_of(samples, background) && (point_ == samples_ || impossible_);
    }
    // Another thread is making lists, for which refine() only waits.
    bool waits() const { return lists_in_work_.valid(); }

    // Draws the average into `area` of the bound framebuffer with a program made from average.frag; the window's DrawBlock is
    // uploaded.
    void draw(const Program& average, const VertexArray& no_vertices, const Block& area) const;

private:
    bool is_of(int samples, const Background& background) const { return samples == samples_ && background == background_; }
    void begin(const Source& source);
    bool have_lists(const Source& source);
    void compile(const Source& source);
    void trace_strip(const Source& source, const Block& strip);
    bool decide_strip(const Source& source, const Block& strip, const Deadline& deadline);
    void add_strip(const Source& source, const Block& strip);
    Pixel offset() const;  // of the current points in their pixels

    int samples_ = 0;  // that it is made for; 0: none yet
    Background background_;
    bool begun_ = false;
    bool impossible_ = false;
    int point_ = 0;  // that is in work, of samples_
    int row_ = 0;    // the first of the strip that is in work
    int strip_height_ = 0;
    bool strip_traced_ = false;

    CandidateLists lists_;
    int lists_side_ = 0;  // that the lists are for; 0: they are of another picture
    std::future<CandidateLists> lists_in_work_;
    int side_in_work_ = 0;  // likewise

    SceneTables tables_;
    std::vector<std::string> defines_;  // that the programs were compiled with
    Program trace_;
    Program shade_;
    VertexArray no_vertices_;
    Buffer draw_buffer_;
    DrawBlock frame_;
    NumberTarget visible_;
    Texture sums_;
    Framebuffer sums_framebuffer_;
    PictureSize sums_size_{0, 0};
};

}  // namespace sphereview

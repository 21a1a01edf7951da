// A scene on the GPU: the spheres, their colours and the lists of tiles, in uniform buffers or textures.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "exact/candidates.hpp"
#include "exact/drawn.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"
#include "gpu/table.hpp"
#include "scene/scene.hpp"
#include "shade/shading.hpp"
#include "tiles/build_lists.hpp"
#include "tiles/live_lists.hpp"

namespace sphereview {

inline constexpr TileCosts gpu_tile_costs = {.smallest_shift = 1, .candidate = 4.0, .test = 1.0};

// The scene is too large for the context, but perhaps not for another renderer.
class TooLarge : public RenderError {
public:
    using RenderError::RenderError;
};

// A drawn sphere's colour in a window; the last byte is 255 if the sphere is selected, else 0.
using ShownColor = std::array<std::uint8_t, 4>;

// The colours of all drawn spheres, none selected: the scene's, or false ones for Shading::id.
std::vector<ShownColor> shown_colors(const Scene& scene, const DrawnSpheres& drawn, Shading shading = Shading::flat);
// The colour of one sphere, not selected.
ShownColor shown_color(const Scene& scene, std::int32_t number, Shading shading);

// A background for shaders: 0..1, with alpha.
glm::vec4 shown_background(const Background& background);

// The block for trace.frag, without the part that is drawn. `scale`: the drawn spheres'.
DrawBlock draw_block_of(const CandidateLists& lists, const Camera& camera, PictureSize size, int scale);

// Uploads the block and binds it for the next draw.
void upload_draw_block(const Buffer& buffer, const DrawBlock& block);

class SceneTables {
public:
    // `spare_spheres`: textures get room for so many more.
    explicit SceneTables(const TextureBounds& bounds = {}, std::size_t spare_spheres = 0);

    // How many spheres the uniform buffer holds: at least 1,024. More are in textures.
    int uniform_capacity() const { return uniform_capacity_; }

    // The defines by which shaders find a scene with these lists. Throws TooLarge if the context cannot hold the scene.
    std::vector<std::string> defines_for(const DrawnSpheres& spheres, const CandidateLists& lists) const;

    // Replaces all but the colours. Throws as defines_for(), before it uploads anything.
    void upload(const DrawnSpheres& spheres, const CandidateLists& lists);
    // `colors`: one for each sphere.
    void upload_colors(std::span<const ShownColor> colors);

    // Whether the spheres are in textures, which take edits in proportion to the changed texels. The uniform buffer is quickly
    // uploaded anew instead.
    bool take_edits_of(const DrawnSpheres& spheres) const { return !fits_in_block(spheres); }
    // Uploads what changed, if take_edits_of(). The lists must have kept their sizes.
    void update(const DrawnSpheres& spheres, const CandidateLists& lists, const LiveLists::Changed& changed);
    // Uploads the colours of the spheres with these indices, in any order.
    void update_colors(std::span<const ShownColor> colors, std::span<const std::uint32_t> indices);

    // Where the spheres are: "uniform buffer", "buffer textures" or "2D textures".
    std::string storage() const;

    // Binds everything for the next draws: others may have bound other objects since.
    void bind() const;

private:
    // Where the spheres and lists are; each variant has its own shaders.
    struct Storage {
        bool in_block = true;
        TableLimits tables;
    };
    Storage storage_for(const DrawnSpheres& spheres, const CandidateLists& lists) const;

    bool fits_in_block(const DrawnSpheres& spheres) const { return spheres.size() <= static_cast<std::size_t>(uniform_capacity_); }

    TextureBounds bounds_;
    std::size_t spare_spheres_;
    int uniform_capacity_ = 0;
    Storage storage_;
    Buffer sphere_buffer_;
    Buffer color_buffer_;
    Table sphere_table_;
    Table color_table_;
    Table candidate_table_;
    Table list_begin_table_;
};

}  // namespace sphereview

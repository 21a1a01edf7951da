// The uniform blocks as C++ writes them. Twins: shaders/draw.glsl, spheres.glsl and candidates.glsl; gpu/program.cpp compares the
// offsets with those that GL reports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "exact/candidates.hpp"

namespace sphereview {

// std140 layout of the block `Draw`.
struct DrawBlock {
    glm::vec4 forward{0.0F};  // w: the reach of the rays' origins
    glm::vec4 right{0.0F};
    glm::vec4 up{0.0F};
    glm::vec4 background{0.0F};
    glm::ivec2 picture_size{0};
    glm::ivec2 block_origin{0};
    float error_scale = 0.0F;
    std::int32_t all_doubtful = 0;
    std::int32_t level_count = 0;
    std::int32_t grid_shift = 0;
    glm::ivec2 window_corner{0};
    std::int32_t hovered = -1;
    float outline = 0.0F;
    std::int32_t checkerboard = 0;
    std::int32_t shading = 0;
    float nearest_depth = 0.0F;
    float inverse_depth_range = 1.0F;
    glm::vec4 axis_right{0.0F};
    glm::vec4 axis_up{0.0F};
    glm::vec4 axis_toward{0.0F};
    glm::vec4 key_light{0.0F};
    glm::vec4 sun_light{0.0F};
    std::array<glm::ivec4, most_tile_levels> levels{};
};

struct BlockMember {
    const char* name;
    std::size_t offset;
};

inline constexpr std::array<BlockMember, 23> draw_members = {{
    {"forward", offsetof(DrawBlock, forward)},
    {"right", offsetof(DrawBlock, right)},
    {"up", offsetof(DrawBlock, up)},
    {"background", offsetof(DrawBlock, background)},
    {"picture_size", offsetof(DrawBlock, picture_size)},
    {"block_origin", offsetof(DrawBlock, block_origin)},
    {"error_scale", offsetof(DrawBlock, error_scale)},
    {"all_doubtful", offsetof(DrawBlock, all_doubtful)},
    {"level_count", offsetof(DrawBlock, level_count)},
    {"grid_shift", offsetof(DrawBlock, grid_shift)},
    {"window_corner", offsetof(DrawBlock, window_corner)},
    {"hovered", offsetof(DrawBlock, hovered)},
    {"outline", offsetof(DrawBlock, outline)},
    {"checkerboard", offsetof(DrawBlock, checkerboard)},
    {"shading", offsetof(DrawBlock, shading)},
    {"nearest_depth", offsetof(DrawBlock, nearest_depth)},
    {"inverse_depth_range", offsetof(DrawBlock, inverse_depth_range)},
    {"axis_right", offsetof(DrawBlock, axis_right)},
    {"axis_up", offsetof(DrawBlock, axis_up)},
    {"axis_toward", offsetof(DrawBlock, axis_toward)},
    {"key_light", offsetof(DrawBlock, key_light)},
    {"sun_light", offsetof(DrawBlock, sun_light)},
    {"levels", offsetof(DrawBlock, levels)},
}};

static_assert(sizeof(DrawBlock) == 336);
static_assert(sizeof(glm::vec4) == 16, "an element of the arrays in the blocks Spheres and Colors");

static_assert(most_tile_levels == 8, "levels in draw.glsl");
static_assert(sizeof(Candidate) == 8, "two 32-bit numbers a texel in candidates.glsl");

// Where each block is bound.
enum class BlockBinding : unsigned { draw = 0, spheres = 1, colors = 2 };

// The texture unit of each sampler, by its name in the shaders.
enum class TextureUnit : int {
    visible_spheres,
    sphere_table,
    color_table,
    candidate_table,
    list_begin_table,
    marks,
    busy_cells,
    image
};
inline constexpr std::array<const char*, 8> sampler_names = {"visible_spheres",  "sphere_table", "color_table", "candidate_table",
                                                             "list_begin_table", "marks",        "busy_cells",  "image"};

// A uniform block is guaranteed 16 KiB, 1,024 spheres; more is used up to this, which every desktop GPU offers.
inline constexpr int largest_uniform_block = 65536;

}  // namespace sphereview

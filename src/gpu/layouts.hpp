// The uniform blocks as C++ writes them. Twins: shaders/frame.glsl, spheres.glsl and candidates.glsl; gpu/program.cpp compares the
// offsets with those that GL reports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "exact/candidates.hpp"

namespace sphereview {

// std140 layout of the block `Frame`.
struct FrameBlock {
    glm::vec4 forward{0.0F};
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
    glm::ivec2 point_offset{0};
    std::int32_t point_shift = 0;
    std::int32_t padding = 0;  // std140 begins an array at a multiple of 16 bytes
    std::array<glm::ivec4, most_tile_levels> levels{};
};

struct BlockMember {
    const char* name;
    std::size_t offset;
};

inline constexpr std::array<BlockMember, 23> frame_members = {{
    {"forward", offsetof(FrameBlock, forward)},
    {"right", offsetof(FrameBlock, right)},
    {"up", offsetof(FrameBlock, up)},
    {"background", offsetof(FrameBlock, background)},
    {"picture_size", offsetof(FrameBlock, picture_size)},
    {"block_origin", offsetof(FrameBlock, block_origin)},
    {"error_scale", offsetof(FrameBlock, error_scale)},
    {"all_doubtful", offsetof(FrameBlock, all_doubtful)},
    {"level_count", offsetof(FrameBlock, level_count)},
    {"grid_shift", offsetof(FrameBlock, grid_shift)},
    {"window_corner", offsetof(FrameBlock, window_corner)},
    {"hovered", offsetof(FrameBlock, hovered)},
    {"outline", offsetof(FrameBlock, outline)},
    {"checkerboard", offsetof(FrameBlock, checkerboard)},
    {"shading", offsetof(FrameBlock, shading)},
    {"nearest_depth", offsetof(FrameBlock, nearest_depth)},
    {"inverse_depth_range", offsetof(FrameBlock, inverse_depth_range)},
    {"axis_right", offsetof(FrameBlock, axis_right)},
    {"axis_up", offsetof(FrameBlock, axis_up)},
    {"axis_toward", offsetof(FrameBlock, axis_toward)},
    {"point_offset", offsetof(FrameBlock, point_offset)},
    {"point_shift", offsetof(FrameBlock, point_shift)},
    {"levels", offsetof(FrameBlock, levels)},
}};

static_assert(sizeof(FrameBlock) == 320);
static_assert(sizeof(glm::vec4) == 16, "an element of the arrays in the blocks Spheres and Colors");

static_assert(most_tile_levels == 8, "levels in frame.glsl");
static_assert(sizeof(Candidate) == 8, "two 32-bit numbers a texel in candidates.glsl");

// Where each block is bound.
enum class BlockBinding : unsigned { frame = 0, spheres = 1, colors = 2 };

// The texture unit of each sampler, by its name in the shaders.
enum class TextureUnit : int {
    visible_spheres,
    sphere_table,
    color_table,
    candidate_table,
    list_begin_table,
    marks,
    busy_cells,
    sums
};
inline constexpr std::array<const char*, 8> sampler_names = {"visible_spheres",  "sphere_table", "color_table", "candidate_table",
                                                             "list_begin_table", "marks",        "busy_cells",  "sums"};

// A uniform block is guaranteed 16 KiB, 1,024 spheres; more is used up to this, which every desktop GPU offers.
inline constexpr int largest_uniform_block = 65536;

}  // namespace sphereview

// The uniform blocks as C++ writes them. Twins: shaders/frame.glsl and shaders/spheres.glsl; gpu/program.cpp compares the
// offsets with those that GL reports.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace sphereview {

// std140 layout of the block `Frame`.
struct FrameBlock {
    glm::vec4 forward{0.0F};
    glm::vec4 right{0.0F};
    glm::vec4 up{0.0F};
    glm::vec4 background{0.0F};
    glm::ivec2 picture_size{0};
    glm::ivec2 block_origin{0};
    std::int32_t sphere_count = 0;
    float error_scale = 0.0F;
    std::int32_t all_doubtful = 0;
    std::int32_t padding = 0;  // std140 rounds a block up to 16 bytes
};

struct BlockMember {
    const char* name;
    std::size_t offset;
};

inline constexpr std::array<BlockMember, 9> frame_members = {{
    {"forward", offsetof(FrameBlock, forward)},
    {"right", offsetof(FrameBlock, right)},
    {"up", offsetof(FrameBlock, up)},
    {"background", offsetof(FrameBlock, background)},
    {"picture_size", offsetof(FrameBlock, picture_size)},
    {"block_origin", offsetof(FrameBlock, block_origin)},
    {"sphere_count", offsetof(FrameBlock, sphere_count)},
    {"error_scale", offsetof(FrameBlock, error_scale)},
    {"all_doubtful", offsetof(FrameBlock, all_doubtful)},
}};

static_assert(sizeof(FrameBlock) == 96);
static_assert(sizeof(glm::vec4) == 16, "an element of the arrays in the blocks Spheres and Colors");

// Where each block is bound.
enum class BlockBinding : unsigned { frame = 0, spheres = 1, colors = 2 };

// A uniform block is guaranteed 16 KiB, 1,024 spheres; more is used up to this, which every desktop GPU offers.
inline constexpr int largest_uniform_block = 65536;

}  // namespace sphereview

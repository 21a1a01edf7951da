// Long arrays for shaders, in buffer textures, or in 2D textures where those are too short: 2D textures alone would draw 11 to 34 %
// slower on llvmpipe. Spheres that fit are in the uniform buffer instead (4,096 on most drivers, at least 1,024). What textures
// cannot hold goes to the CPU renderer under --backend auto. Twin: shaders/tables.glsl.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"

namespace sphereview {

// Bounds on the use of textures, in texels; tests set less than the context offers.
struct TextureBounds {
    std::size_t in_buffer = std::numeric_limits<std::size_t>::max();
    std::size_t side = std::numeric_limits<std::size_t>::max();
};

// How the context holds long arrays.
struct TableLimits {
    std::size_t most_texels = 0;  // in one table
    std::optional<int> shift;     // tables are 2D textures of 2^shift columns; none: buffer textures
};

// Buffer textures if they hold `texels`, or at least as much as 2D textures do.
TableLimits table_limits(std::size_t texels, const TextureBounds& bounds);

// The shaders' defines for these limits.
std::vector<std::string> table_defines(const TableLimits& limits);

// What a texel is.
enum class TexelKind { vec4, rgba8, uint_pair, uint };

// One array, in a buffer texture or a 2D texture.
class Table {
public:
    // Uploads `count` texels, with room for `spare` more, in all fewer than limits.most_texels, and binds the texture to its unit.
    // Shaders may fetch one texel beyond.
    void upload(const void* data, std::size_t count, TexelKind kind, TextureUnit unit, const TableLimits& limits,
                std::size_t spare = 0);

    // Replaces `count` uploaded or spare texels from number `first` on.
    void update(const void* texels, std::size_t first, std::size_t count);

    // Binds the texture, if anything was uploaded, to its unit, which becomes the active one.
    void bind(TextureUnit unit) const;

private:
    Buffer buffer_;
    Texture texture_;
    TexelKind kind_ = TexelKind::vec4;
    bool flat_ = false;  // a 2D texture
    int shift_ = 0;      // of 2^shift columns
};

}  // namespace sphereview

// A buffer of one number for each pixel, drawn by one shader and read by others.
#pragma once

#include <cstdint>
#include <span>

#include "exact/candidates.hpp"
#include "exact/visible.hpp"
#include "gpu/gl_object.hpp"
#include "gpu/layouts.hpp"

namespace sphereview {

// Draws are split into blocks of at most this side: a watchdog ends one that takes seconds.
inline constexpr int preferred_block_side = 2048;

// The part of the block in the range; nothing if its width or height is 0 or less.
Block common(const Block& block, const PixelRange& range);

// Draws a triangle over `block` of the bound framebuffer, in GL's coordinates, with the program in use and scissored.
void draw_block(const VertexArray& no_vertices, const Block& block);

// Row 0 is the top row. Draw calls leave this target bound as the framebuffer, for drawing and reading.
class NumberTarget {
public:
    NumberTarget();

    // The largest width and height that the context offers.
    int largest_side() const { return largest_side_; }

    // Makes the buffer at least so large, up to largest_side(); loses its content when it grows. Throws RenderError.
    void require(int width, int height);

    // Writes the number everywhere. (Mesa would clear a part, with the scissor, as slowly as it draws.)
    void fill(std::int32_t number) const;

    // Writes the block with the program in use.
    void draw(const VertexArray& no_vertices, const Block& block) const;

    // The block's texels, row by row.
    void read(const Block& block, std::span<std::int32_t> numbers) const;

    void bind(TextureUnit unit) const;

private:
    Texture texture_;
    Framebuffer framebuffer_;
    int largest_side_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace sphereview

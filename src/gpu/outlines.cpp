#include "gpu/outlines.hpp"

#include <algorithm>
#include <cmath>

namespace sphereview {

namespace {

constexpr int cell_shift = 3;  // as in shaders/marks.glsl

// By so many pixels on each side, but not beyond the picture.
PixelRange grown(const PixelRange& range, int by, const glm::ivec2& size) {
    return {std::max(range.left - by, 0), std::max(range.top - by, 0), std::min(range.right + by, size.x - 1),
            std::min(range.bottom + by, size.y - 1)};
}

// From the first to the last, inclusive.
Block block_of(int left, int top, int right, int bottom) { return {left, top, right - left + 1, bottom - top + 1}; }

}  // namespace

void Outlines::draw(const OutlinePrograms& programs, const VertexArray& no_vertices, const NumberTarget& visible,
                    const DrawBlock& block, const PixelRange& range, const WindowArea& area, GLuint window) {
    if (range.empty()) return;
    const int step = 1 << block.grid_shift;
    // In a coarse picture a sphere may be seen beside its range.
    const int reach = static_cast<int>(std::ceil(block.outline)) + 3 + step;
    const PixelRange drawn = grown(range, reach, block.picture_size);
    const PixelRange looked_at = grown(drawn, reach, block.picture_size);
    marks_.require(block.picture_size.x, block.picture_size.y);
    busy_.require(((block.picture_size.x - 1) >> cell_shift) + 1, ((block.picture_size.y - 1) >> cell_shift) + 1);
    visible.bind(TextureUnit::visible_spheres);
    glUseProgram(step > 1 ? programs.coarse_mark.name() : programs.mark.name());
    marks_.draw(no_vertices, block_of(looked_at.left, looked_at.top, looked_at.right, looked_at.bottom));
    marks_.bind(TextureUnit::marks);
    glUseProgram(programs.busy.name());
    // Cells at the rim see what earlier redraws left beside the marks, and may be busy without need.
    busy_.draw(no_vertices, block_of(looked_at.left >> cell_shift, looked_at.top >> cell_shift, looked_at.right >> cell_shift,
                                     looked_at.bottom >> cell_shift));

    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, window);
    const int left = std::max(block.window_corner.x + drawn.left, area.x);
    const int right = std::min(block.window_corner.x + drawn.right, area.x + area.width - 1);
    const int bottom = std::max(block.window_corner.y - drawn.bottom, area.y);
    const int top = std::min(block.window_corner.y - drawn.top, area.y + area.height - 1);
    if (right < left || top < bottom) return;
    busy_.bind(TextureUnit::busy_cells);
    glUseProgram(programs.outline.name());
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_block(no_vertices, block_of(left, bottom, right, top));
    glDisable(GL_BLEND);
}

}  // namespace sphereview

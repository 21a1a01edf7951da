#include "gpu/outlines.hpp"

#include <algorithm>
#include <cmath>

namespace sphereview {

namespace {

// By so many pixels on each side, but not beyond the picture.
PixelRange grown(const PixelRange& range, int by, const glm::ivec2& size) {
    return {std::max(range.left - by, 0), std::max(range.top - by, 0), std::min(range.right + by, size.x - 1),
            std::min(range.bottom + by, size.y - 1)};
}

}  // namespace

PixelRange united(const PixelRange& a, const PixelRange& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

void Outlines::draw(const OutlinePrograms& programs, const VertexArray& no_vertices, const NumberTarget& visible,
                    const FrameBlock& frame, const PixelRange& range, const WindowArea& area, GLuint window) {
    if (range.empty()) return;
    const int step = frame.grid_step;
    // A coarse texel of a sphere may stand for pixels beside its range.
    const int reach = static_cast<int>(std::ceil(frame.outline)) + 2 + step;
    const PixelRange drawn = grown(range, reach, frame.picture_size);
    const PixelRange looked_at = grown(drawn, reach, frame.picture_size);
    const Block grid{looked_at.left / step, looked_at.top / step, looked_at.right / step - looked_at.left / step + 1,
                     looked_at.bottom / step - looked_at.top / step + 1};
    marks_.require((frame.picture_size.x + step - 1) / step, (frame.picture_size.y + step - 1) / step);
    visible.bind(TextureUnit::visible_spheres);
    glUseProgram(programs.mark.name());
    marks_.draw(no_vertices, grid, {grid.x, grid.y, grid.x + grid.width - 1, grid.y + grid.height - 1}, 0);

    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, window);
    const int left = std::max(frame.window_corner.x + drawn.left, area.x);
    const int right = std::min(frame.window_corner.x + drawn.right, area.x + area.width - 1);
    const int bottom = std::max(frame.window_corner.y - drawn.bottom, area.y);
    const int top = std::min(frame.window_corner.y - drawn.top, area.y + area.height - 1);
    if (right < left || top < bottom) return;
    marks_.bind(TextureUnit::marks);
    glUseProgram(programs.outline.name());
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_block(no_vertices, {left, bottom, right - left + 1, top - bottom + 1});
    glDisable(GL_BLEND);
}

}  // namespace sphereview

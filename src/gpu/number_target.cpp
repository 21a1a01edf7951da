#include "gpu/number_target.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/error.hpp"

namespace sphereview {

Block common(const Block& block, const PixelRange& range) {
    const int left = std::max(block.x, range.left);
    const int top = std::max(block.y, range.top);
    return {left, top, std::min(block.x + block.width - 1, range.right) - left + 1,
            std::min(block.y + block.height - 1, range.bottom) - top + 1};
}

void draw_block(const VertexArray& no_vertices, const Block& block) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(block.x, block.y, block.width, block.height);
    glViewport(block.x, block.y, block.width, block.height);
    glBindVertexArray(no_vertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDisable(GL_SCISSOR_TEST);
}

NumberTarget::NumberTarget() {
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    largest_side_ = std::min({gl_limit(GL_MAX_TEXTURE_SIZE), viewport[0], viewport[1]});
    texture_ = Texture::make();
    framebuffer_ = Framebuffer::make();
}

void NumberTarget::require(int width, int height) {
    assert(width <= largest_side_ && height <= largest_side_);
    if (width <= width_ && height <= height_) return;
    const int new_width = std::max(width, width_);
    const int new_height = std::max(height, height_);
    width_ = height_ = 0;  // unless all goes well
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, new_width, new_height, 0, GL_RED_INTEGER, GL_INT, nullptr);
    read_single_texels();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError("the context cannot draw into 32-bit integers");
    }
    check_gl("making the buffer of visible spheres");
    width_ = new_width;
    height_ = new_height;
}

void NumberTarget::fill(std::int32_t number) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    const std::array<GLint, 4> numbers = {number, 0, 0, 0};  // GL reads four, whatever the format
    glClearBufferiv(GL_COLOR, 0, numbers.data());
}

void NumberTarget::draw(const VertexArray& no_vertices, const Block& block) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    draw_block(no_vertices, block);
}

void NumberTarget::read(const Block& block, std::span<std::int32_t> numbers) const {
    assert(numbers.size() == static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(block.x, block.y, block.width, block.height, GL_RED_INTEGER, GL_INT, numbers.data());
    check_gl("reading the visible spheres back");
}

void NumberTarget::bind(TextureUnit unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace sphereview

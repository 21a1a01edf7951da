#include "gpu/table.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

namespace sphereview {

namespace {

struct Format {
    GLenum internal;
    GLenum format;
    GLenum type;
    std::size_t bytes;
};

Format format_of(TexelKind kind) {
    switch (kind) {
        case TexelKind::vec4: return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
        case TexelKind::rgba8: return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
        case TexelKind::uint_pair: return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8};
        case TexelKind::uint: return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
    }
    return {};
}

// At least `bytes`, a little more for some. llvmpipe (Mesa 22.3) compiles a shader anew for a buffer texture whose size is a
// power of two, and for one whose size has 0 as its second byte, which it takes for the number of mipmaps.
std::size_t size_for_one_shader(std::size_t bytes) {
    while (std::has_single_bit(bytes) || (bytes >> 8 & 0xFF) == 0) bytes += 256;
    return bytes;
}

}  // namespace

TableLimits table_limits(std::size_t texels, const TextureBounds& bounds) {
    const auto in_buffer = std::min(bounds.in_buffer, static_cast<std::size_t>(gl_limit(GL_MAX_TEXTURE_BUFFER_SIZE)));
    const auto side = std::min(bounds.side, static_cast<std::size_t>(gl_limit(GL_MAX_TEXTURE_SIZE)));
    constexpr std::size_t most_columns = 4096;  // few are left over in the last row
    const std::size_t columns = std::bit_floor(std::min(side, most_columns));
    if (texels <= in_buffer || columns * side <= in_buffer) return {in_buffer, std::nullopt};
    return {columns * side, std::countr_zero(columns)};
}

std::vector<std::string> table_defines(const TableLimits& limits) {
    if (!limits.shift) return {};
    return {"TABLE_SHIFT " + std::to_string(*limits.shift)};
}

void Table::bind(TextureUnit unit) const {
    if (!texture_) return;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(flat_ ? GL_TEXTURE_2D : GL_TEXTURE_BUFFER, texture_.name());
}

void Table::upload(const void* data, std::size_t count, TexelKind kind, TextureUnit unit, const TableLimits& limits) {
    const Format format = format_of(kind);
    // A texture keeps the kind that it was first bound as.
    if (!texture_ || flat_ != limits.shift.has_value()) texture_ = make_texture();
    flat_ = limits.shift.has_value();
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    if (!limits.shift) {
        if (!buffer_) buffer_ = make_buffer();
        glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
        const std::size_t size = size_for_one_shader((count + 1) * format.bytes);
        glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_DRAW);
        glBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(count * format.bytes), data);
        glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
        glTexBuffer(GL_TEXTURE_BUFFER, format.internal, buffer_.name());
    } else {
        const auto columns = std::size_t{1} << *limits.shift;
        const std::size_t whole_rows = count / columns;
        const std::size_t rest = count % columns;
        const auto rows = static_cast<GLsizei>(whole_rows + 1);
        glBindTexture(GL_TEXTURE_2D, texture_.name());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), static_cast<GLsizei>(columns), rows, 0, format.format,
                     format.type, nullptr);
        const auto* bytes = static_cast<const char*>(data);
        const auto put = [&](std::size_t first_row, std::size_t width, std::size_t height) {
            if (width == 0 || height == 0) return;
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(first_row), static_cast<GLsizei>(width),
                            static_cast<GLsizei>(height), format.format, format.type, bytes + first_row * columns * format.bytes);
        };
        put(0, columns, whole_rows);
        put(whole_rows, rest, 1);
    }
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace sphereview

#include "gpu/table.hpp"

#include <algorithm>
#include <bit>

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

void Table::upload(const void* data, std::size_t count, TexelKind kind, TextureUnit unit, const TableLimits& limits,
                   std::size_t spare) {
    const Format format = format_of(kind);
    // A texture keeps the kind that it was first bound as.
    if (!texture_ || flat_ != limits.shift.has_value()) texture_ = Texture::make();
    kind_ = kind;
    flat_ = limits.shift.has_value();
    shift_ = limits.shift.value_or(0);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    if (!flat_) {
        if (!buffer_) buffer_ = Buffer::make();
        glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
        const std::size_t size = size_for_one_shader((count + spare + 1) * format.bytes);
        glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_DRAW);
        glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
        glTexBuffer(GL_TEXTURE_BUFFER, format.internal, buffer_.name());
    } else {
        const auto rows = static_cast<GLsizei>(((count + spare) >> shift_) + 1);
        glBindTexture(GL_TEXTURE_2D, texture_.name());
        read_single_texels();
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format.internal), GLsizei{1} << shift_, rows, 0, format.format,
                     format.type, nullptr);
    }
    update(data, 0, count);
    glActiveTexture(GL_TEXTURE0);
}

void Table::update(const void* texels, std::size_t first, std::size_t count) {
    if (count == 0) return;
    const Format format = format_of(kind_);
    if (!flat_) {
        glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
        glBufferSubData(GL_TEXTURE_BUFFER, static_cast<GLintptr>(first * format.bytes),
                        static_cast<GLsizeiptr>(count * format.bytes), texels);
        return;
    }
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto columns = std::size_t{1} << shift_;
    const auto* bytes = static_cast<const char*>(texels);
    // The rest of a row, whole rows at a time, the beginning of a row.
    while (count > 0) {
        const std::size_t column = first & (columns - 1);
        const std::size_t width = std::min(columns - column, count);
        const std::size_t height = width == columns ? count >> shift_ : 1;
        glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(column), static_cast<GLint>(first >> shift_),
                        static_cast<GLsizei>(width), static_cast<GLsizei>(height), format.format, format.type, bytes);
        first += width * height;
        count -= width * height;
        bytes += width * height * format.bytes;
    }
}

}  // namespace sphereview

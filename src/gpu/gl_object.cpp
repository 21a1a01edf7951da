#include "gpu/gl_object.hpp"

#include <cstdio>
#include <new>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

GLint gl_limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void read_single_texels() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

GlDescription describe_gl() {
    const auto text = [](GLenum name) {
        const auto* value = reinterpret_cast<const char*>(glGetString(name));
        return on_one_line(value != nullptr ? value : "unknown");
    };
    GlDescription description{text(GL_VENDOR),
                              text(GL_RENDERER),
                              text(GL_VERSION),
                              text(GL_SHADING_LANGUAGE_VERSION),
                              gl_limit(GL_MAX_UNIFORM_BLOCK_SIZE),
                              gl_limit(GL_MAX_TEXTURE_SIZE),
                              {}};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, description.largest_viewport.data());
    return description;
}

void check_gl(const char* during) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) throw std::bad_alloc();
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), "0x%04x", error);
    throw RenderError(std::string(during) + ": GL error " + code.data());
}

}  // namespace sphereview

// Owners of GL objects. All of this room assumes a current OpenGL 3.3 context with its functions loaded.
#pragma once

#include <glad/gl.h>

#include <array>
#include <string>
#include <utility>

namespace sphereview {

// A move-only owner of one GL name; 0 is the empty state.
template <void (*Delete)(GLuint)>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint name) : name_(name) {}
    ~GlObject() { reset(); }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    void reset() {
        if (name_ != 0) Delete(std::exchange(name_, 0));
    }

    GLuint name_ = 0;
};

namespace gl_delete {
inline void buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void texture(GLuint name) { glDeleteTextures(1, &name); }
inline void framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void shader(GLuint name) { glDeleteShader(name); }
inline void program(GLuint name) { glDeleteProgram(name); }
}  // namespace gl_delete

using Buffer = GlObject<gl_delete::buffer>;
using Texture = GlObject<gl_delete::texture>;
using Framebuffer = GlObject<gl_delete::framebuffer>;
using VertexArray = GlObject<gl_delete::vertex_array>;
using Shader = GlObject<gl_delete::shader>;
using Program = GlObject<gl_delete::program>;

// A new, nameless object of each kind.
Buffer make_buffer();
Texture make_texture();
Framebuffer make_framebuffer();
VertexArray make_vertex_array();

// An integer limit of the context, such as GL_MAX_TEXTURE_SIZE.
GLint gl_limit(GLenum name);

// What the current context says of itself, and the limits that matter here.
struct GlDescription {
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string glsl;
    GLint largest_uniform_block = 0;  // bytes
    GLint largest_texture_side = 0;   // texels
    std::array<GLint, 2> largest_viewport{};
};
GlDescription describe_gl();

// Throws RenderError "DURING: GL error ..." if the context has an error; std::bad_alloc when its memory did not suffice.
void check_gl(const char* during);

}  // namespace sphereview

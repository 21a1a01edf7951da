// Owners of GL objects. This room assumes a current OpenGL 3.3 context with its functions loaded.
#pragma once

#include <glad/gl.h>

#include <array>
#include <string>
#include <utility>

namespace sphereview {

// A move-only owner of one GL name; 0 is the empty state. Generate: the function that makes names, if there is one.
template <auto& Delete, auto&... Generate>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint name) : name_(name) {}
    static GlObject make() {
        GlObject object;
        (Generate(1, &object.name_), ...);
        return object;
    }
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
        if (name_ == 0) return;
        if constexpr (sizeof...(Generate) > 0) {
            Delete(1, &name_);
        } else {
            Delete(name_);
        }
        name_ = 0;
    }

    GLuint name_ = 0;
};

using Buffer = GlObject<glDeleteBuffers, glGenBuffers>;
using Texture = GlObject<glDeleteTextures, glGenTextures>;
using Framebuffer = GlObject<glDeleteFramebuffers, glGenFramebuffers>;
using VertexArray = GlObject<glDeleteVertexArrays, glGenVertexArrays>;
using Shader = GlObject<glDeleteShader>;
using Program = GlObject<glDeleteProgram>;

// An integer limit of the context, such as GL_MAX_TEXTURE_SIZE.
GLint gl_limit(GLenum name);

// Turns filtering and mipmaps of the bound 2D texture off. With these an integer texture is incomplete and texelFetch reads 0,
// which is a sphere.
void read_single_texels();

// The current context's strings, and the limits that matter here.
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

// Throws RenderError "DURING: GL error ..." if the context has an error, std::bad_alloc if it is a lack of memory.
void check_gl(const char* during);

}  // namespace sphereview

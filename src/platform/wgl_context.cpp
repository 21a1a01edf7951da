#include <glad/gl.h>

#include "base/error.hpp"
#include "platform/gl_context.hpp"
#include "platform/glfw.hpp"

namespace sphereview {

#ifdef _WIN32

namespace {

class HiddenWindow final : public GlContext {
public:
    HiddenWindow() {
        if (glfw().Init() == GLFW_FALSE) fail("Windows has no desktop to open a hidden window on: ", RenderFault::other);
        hint_at_context();
        window_ = glfw().CreateWindow(16, 16, "sphereview", nullptr, nullptr);
        if (window_ == nullptr) fail("no hidden window with OpenGL 3.3 can be opened: ", RenderFault::old_opengl);
        glfw().MakeContextCurrent(window_);
        if (gladLoadGL(glfw().GetProcAddress) == 0 || !GLAD_GL_VERSION_3_3) {
            fail("the hidden window's context has no OpenGL 3.3 functions: ", RenderFault::old_opengl);
        }
    }
    ~HiddenWindow() override { glfw().Terminate(); }  // with its windows

private:
    [[noreturn]] static void fail(const char* what, RenderFault fault) {
        const std::string why = last_glfw_error();
        glfw().Terminate();
        throw RenderError(what + why, fault);
    }

    GLFWwindow* window_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> open_wgl() { return std::make_unique<HiddenWindow>(); }

#else

std::unique_ptr<GlContext> open_wgl() { throw RenderError("WGL is a part of Windows", RenderFault::no_library); }

#endif

}  // namespace sphereview

#include "platform/glfw.hpp"

#include "base/error.hpp"
#include "platform/dynamic_library.hpp"

namespace sphereview {

namespace {

Glfw open_glfw() {
    Glfw glfw;
#ifdef SPHEREVIEW_LINKS_GLFW
#define SPHEREVIEW_FIND(name) glfw.name = &::glfw##name;
#else
    static const DynamicLibrary library({"libglfw.so.3", "libglfw.so", "libglfw.3.dylib", "glfw3.dll"});
    if (!library) throw RenderError("there is no GLFW to open a window with: " + library.error());
#define SPHEREVIEW_FIND(name)                                                      \
    glfw.name = reinterpret_cast<decltype(glfw.name)>(library.find("glfw" #name)); \
    if (glfw.name == nullptr) throw RenderError("this GLFW has no glfw" #name "; expected 3.3 or later");
#endif
    SPHEREVIEW_GLFW_FUNCTIONS(SPHEREVIEW_FIND)
#undef SPHEREVIEW_FIND
    return glfw;
}

}  // namespace

const Glfw& glfw() {
    static const Glfw functions = open_glfw();
    return functions;
}

}  // namespace sphereview

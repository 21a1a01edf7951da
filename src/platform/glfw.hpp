// GLFW, opened at run time, so that the program starts, and renders, without it.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "platform/dynamic_library.hpp"

namespace sphereview {

// The functions that this program uses, without their prefix.
// clang-format off
#define SPHEREVIEW_GLFW_FUNCTIONS(X) \
    X(CreateStandardCursor) X(CreateWindow) X(DestroyCursor) X(DestroyWindow) X(FocusWindow) \
    X(GetClipboardString) X(GetError) X(GetFramebufferSize) X(GetKey) X(GetKeyName) X(GetMonitorContentScale) X(GetMonitorWorkarea) \
    X(GetMonitors) X(GetPrimaryMonitor) X(GetProcAddress) X(GetWindowAttrib) X(GetWindowContentScale) \
    X(GetWindowPos) X(GetWindowSize) X(GetWindowUserPointer) X(Init) X(InitHint) X(MakeContextCurrent) X(PollEvents) \
    X(PostEmptyEvent) X(SetCharCallback) X(SetClipboardString) X(SetCursor) X(SetCursorEnterCallback) \
    X(SetCursorPosCallback) X(SetDropCallback) X(SetFramebufferSizeCallback) X(SetKeyCallback) \
    X(SetMouseButtonCallback) X(SetScrollCallback) X(SetWindowCloseCallback) X(SetWindowContentScaleCallback) \
    X(SetWindowFocusCallback) X(SetWindowIcon) X(SetWindowPos) X(SetWindowRefreshCallback) X(SetWindowShouldClose) \
    X(SetWindowTitle) X(SetWindowUserPointer) X(ShowWindow) X(SwapBuffers) X(SwapInterval) X(Terminate) \
    X(WaitEvents) X(WaitEventsTimeout) X(WindowHint) X(WindowHintString)
// clang-format on

struct Glfw {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name stands in none
#define SPHEREVIEW_DECLARE(name) decltype(&::glfw##name) name = nullptr;
    SPHEREVIEW_GLFW_FUNCTIONS(SPHEREVIEW_DECLARE)
#undef SPHEREVIEW_DECLARE
};

inline Glfw open_glfw() {
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

// Opened at the first call. Throws RenderError where there is no GLFW.
inline const Glfw& glfw() {
    static const Glfw functions = open_glfw();
    return functions;
}

// GLFW's last error on one line: it may quote anything, such as the display's name.
inline std::string last_glfw_error() {
    const char* description = nullptr;
    glfw().GetError(&description);
    return description != nullptr ? on_one_line(description) : "no reason given";
}

// The next window has OpenGL 3.3 core, and is hidden at first.
inline void hint_at_context() {
    glfw().WindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfw().WindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfw().WindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfw().WindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfw().WindowHint(GLFW_DEPTH_BITS, 0);
    glfw().WindowHint(GLFW_STENCIL_BITS, 0);
    glfw().WindowHint(GLFW_VISIBLE, GLFW_FALSE);
}

}  // namespace sphereview

#include <glad/egl.h>
// After EGL's header, which it completes.
#include <glad/gl.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "platform/dynamic_library.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

namespace {

using Function = void (*)();
using GetProcAddress = Function (*)(const char*);

// libEGL, opened once.
const DynamicLibrary& library() {
    static const DynamicLibrary egl({"libEGL.so.1", "libEGL.so"});
    return egl;
}

Function load_function(const char* name) {
    if (void* exported = library().find(name)) return reinterpret_cast<Function>(exported);
    static const auto get_proc_address = reinterpret_cast<GetProcAddress>(library().find("eglGetProcAddress"));
    return get_proc_address != nullptr ? get_proc_address(name) : nullptr;
}

[[noreturn]] void fail(const std::string& step, RenderFault fault = RenderFault::other) {
    std::array<char, 16> code{};
    std::snprintf(code.data(), code.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
    throw RenderError(step + " failed (EGL error " + code.data() + ")", fault);
}

// Loads EGL's client functions; what needs a display is loaded again with it.
void load_client() {
    if (!library()) throw RenderError("libEGL cannot be opened: " + library().error(), RenderFault::no_library);
    if (gladLoadEGL(nullptr, load_function) == 0) throw RenderError("libEGL lacks functions that every EGL has");
}

bool has_extension(const char* list, std::string_view name) {
    std::string_view rest = list != nullptr ? list : "";
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        if (word == name) return true;
        rest.remove_prefix(word.size() == rest.size() ? rest.size() : word.size() + 1);
    }
    return false;
}

std::vector<EGLDeviceEXT> query_devices() {
    if (eglQueryDevicesEXT == nullptr) return {};
    EGLint count = 0;
    if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (eglQueryDevicesEXT(count, devices.data(), &count) == EGL_FALSE) return {};
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

const char* client_extensions() { return eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS); }

bool x_or_wayland_is_there() { return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr; }

EGLDisplay display_of(const EglDevice& device) {
    switch (device.kind) {
        case EglDevice::Kind::device: {
            const auto devices = query_devices();
            if (static_cast<std::size_t>(device.index) >= devices.size()) throw RenderError("there is no such EGL device");
            return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(device.index)], nullptr);
        }
        case EglDevice::Kind::surfaceless:
            return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        case EglDevice::Kind::default_display: return eglGetDisplay(EGL_DEFAULT_DISPLAY);
    }
    return EGL_NO_DISPLAY;
}

class EglContext final : public GlContext {
public:
    explicit EglContext(const EglDevice& device) {
        load_client();
        display_ = display_of(device);
        if (display_ == EGL_NO_DISPLAY) fail("opening the display", RenderFault::no_driver);
        if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize", RenderFault::no_driver);
        try {
            create();
        } catch (...) {
            close();
            throw;
        }
    }
    ~EglContext() override { close(); }

private:
    void create() {
        if (gladLoadEGL(display_, load_function) == 0) throw RenderError("the display's EGL functions cannot be loaded");
        if (eglBindAPI == nullptr || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("eglBindAPI(OpenGL)");
        // Both named: the default SURFACE_TYPE is a window, which no headless display has.
        constexpr std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) fail("eglChooseConfig");
        constexpr std::array<EGLint, 7> version = {
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
        if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext for OpenGL 3.3 core", RenderFault::old_opengl);
        if (!has_extension(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
            constexpr std::array<EGLint, 5> size = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, size.data());
            if (surface_ == EGL_NO_SURFACE) fail("eglCreatePbufferSurface");
        }
        if (eglMakeCurrent(display_, surface_, surface_, context_) == EGL_FALSE) fail("eglMakeCurrent");
        // Anew for each context: another driver has other functions.
        if (gladLoadGL(load_function) == 0 || !GLAD_GL_VERSION_3_3)
            throw RenderError("the context has no OpenGL 3.3 functions", RenderFault::old_opengl);
    }

    void close() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
        eglTerminate(display_);
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace

std::vector<EglDevice> list_egl_devices() {
    load_client();
    std::vector<EglDevice> found;
    const char* extensions = client_extensions();
    if (has_extension(extensions, "EGL_EXT_platform_device") && eglGetPlatformDisplayEXT != nullptr) {
        const auto devices = query_devices();
        for (std::size_t i = 0; i < devices.size(); ++i) {
            const char* about = eglQueryDeviceStringEXT != nullptr ? eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS) : nullptr;
            const bool software = has_extension(about, "EGL_MESA_device_software");
            found.push_back({EglDevice::Kind::device, static_cast<int>(i), "EGL device " + std::to_string(i), software});
        }
    }
    if (has_extension(extensions, "EGL_MESA_platform_surfaceless") && eglGetPlatformDisplayEXT != nullptr) {
        found.push_back({EglDevice::Kind::surfaceless, 0, "EGL surfaceless", false});
    }
    if (!x_or_wayland_is_there()) found.push_back({EglDevice::Kind::default_display, 0, default_display_name, false});
    return found;
}

std::unique_ptr<GlContext> open_egl(const EglDevice& device) { return std::make_unique<EglContext>(device); }

}  // namespace sphereview

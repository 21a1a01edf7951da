// An OpenGL 3.3 core context without a window.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sphereview {

// The context is current, with the GL functions loaded for it, from construction to destruction. One at a time.
class GlContext {
public:
    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    // GL_RENDERER, and whether it is known to draw on the CPU (llvmpipe, softpipe, swrast).
    std::string renderer() const;
    bool is_software() const;

protected:
    GlContext() = default;
};

// Throws RenderError when a limit on the address space leaves too little for a GL driver, which would crash, and `beside`, bytes
// that the caller needs while it draws. Call before opening a context.
void require_address_space_for_gl(std::uint64_t beside = 0);

// Where EGL can look for a GPU.
struct EglDevice {
    enum class Kind { device, surfaceless, default_display };

    Kind kind = Kind::device;
    int index = 0;  // of an EGL device, as `--device` counts
    std::string name;
    bool software = false;  // as the device says
};

inline constexpr const char* default_display_name = "EGL default display";

// Everything EGL offers on this machine: its devices in its order, then the surfaceless platform, then, unless that would
// open a connection to X or Wayland, the default display. Throws RenderError when there is no usable libEGL.
std::vector<EglDevice> list_egl_devices();

// Opens a context on the device. Throws RenderError with the failed step and EGL's error.
std::unique_ptr<GlContext> open_egl(const EglDevice& device);

// Opens Mesa's off-screen software renderer. Throws RenderError; Mesa 25.1 and later no longer have it.
std::unique_ptr<GlContext> open_osmesa();

// Opens the context of a hidden window, which OpenGL on Windows needs. Throws RenderError, on other systems always.
std::unique_ptr<GlContext> open_wgl();

}  // namespace sphereview

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

// Throws RenderError when a limit on the address space leaves too little for a GL driver and `beside`, the bytes of what is made
// while it draws: drivers crash where they get less. To be called before any is opened.
void require_address_space_for_gl(std::uint64_t beside = 0);

// Where EGL can look for a GPU.
struct EglDevice {
    enum class Kind { device, surfaceless, default_display };

    Kind kind = Kind::device;
    int index = 0;  // of an EGL device, as `--device` counts
    std::string name;
    bool software = false;  // by the device's own word
};

inline constexpr const char* default_display_name = "EGL default display";

// Everything EGL offers on this machine: its devices in its order, then the surfaceless platform, then, unless that would
// open a connection to X or Wayland, the default display. Throws RenderError when there is no usable libEGL.
std::vector<EglDevice> list_egl_devices();

// Opens a context there. Throws RenderError with the step that failed and EGL's error.
std::unique_ptr<GlContext> open_egl(const EglDevice& device);

// Opens Mesa's off-screen software renderer. Throws RenderError; Mesa 25.1 and later no longer have it.
std::unique_ptr<GlContext> open_osmesa();

// Opens the context of a hidden window, by which OpenGL is reached on Windows. Throws RenderError, on every other system at once.
std::unique_ptr<GlContext> open_wgl();

}  // namespace sphereview

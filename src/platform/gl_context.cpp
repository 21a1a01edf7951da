#include "platform/gl_context.hpp"

#include <glad/gl.h>

namespace sphereview {

std::string GlContext::renderer() const {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return text != nullptr ? text : "unknown";
}

bool GlContext::is_software() const {
    const std::string name = renderer();
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR"}) {
        if (name.find(software) != std::string::npos) return true;
    }
    return false;
}

}  // namespace sphereview

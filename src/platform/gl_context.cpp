#include "platform/gl_context.hpp"

#include <glad/gl.h>

#include <algorithm>

#include "base/available_memory.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"

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

void require_address_space_for_gl(std::uint64_t beside) {
    // Measured with Mesa's llvmpipe and 2 threads: it crashes at some limits up to 625 MB. Its libraries take 200 MB; each thread,
    // of which it starts at most 32, has a stack and a heap of its own.
    constexpr std::uint64_t libraries = 600'000'000;
    constexpr std::uint64_t of_thread = 150'000'000;
    const auto left = address_space_left();
    const std::uint64_t wanted = libraries + of_thread * static_cast<std::uint64_t>(std::min(worker_count(), 32)) + beside;
    if (!left || *left >= wanted) return;
    throw RenderError("a GL driver may need " + in_bytes(wanted) + " of address space, of whose limit (ulimit -v) " +
                          in_bytes(*left) + " are left",
                      RenderFault::little_memory);
}

}  // namespace sphereview

#include "platform/gl_context.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "platform/dynamic_library.hpp"

namespace sphereview {

namespace {

// From Mesa's GL/osmesa.h, which need not be installed.
using OsmesaHandle = struct osmesa_context*;
using Function = void (*)();
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;

struct Osmesa {
    DynamicLibrary library{{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}};
    OsmesaHandle (*create)(const int*, OsmesaHandle) = nullptr;
    void (*destroy)(OsmesaHandle) = nullptr;
    unsigned char (*make_current)(OsmesaHandle, void*, unsigned, int, int) = nullptr;
    Function (*get_proc_address)(const char*) = nullptr;

    Osmesa() {
        create = reinterpret_cast<decltype(create)>(library.find("OSMesaCreateContextAttribs"));
        destroy = reinterpret_cast<decltype(destroy)>(library.find("OSMesaDestroyContext"));
        make_current = reinterpret_cast<decltype(make_current)>(library.find("OSMesaMakeCurrent"));
        get_proc_address = reinterpret_cast<decltype(get_proc_address)>(library.find("OSMesaGetProcAddress"));
    }
    bool complete() const {
        return create != nullptr && destroy != nullptr && make_current != nullptr && get_proc_address != nullptr;
    }
};

const Osmesa& osmesa() {
    static const Osmesa functions;
    return functions;
}

class OsmesaContext final : public GlContext {
public:
    OsmesaContext() {
        if (!osmesa().library)
            throw RenderError("libOSMesa cannot be opened: " + osmesa().library.error(), RenderFault::no_library);
        if (!osmesa().complete()) throw RenderError("libOSMesa lacks functions that Mesa 12 and later have");
        constexpr std::array<int, 9> wanted = {osmesa_format,
                                               GL_RGBA,
                                               osmesa_profile,
                                               osmesa_core_profile,
                                               osmesa_context_major_version,
                                               3,
                                               osmesa_context_minor_version,
                                               3,
                                               0};
        context_ = osmesa().create(wanted.data(), nullptr);
        if (context_ == nullptr) throw RenderError("OSMesa has no OpenGL 3.3 core context", RenderFault::old_opengl);
        if (osmesa().make_current(context_, screen_.data(), GL_UNSIGNED_BYTE, side, side) == 0 ||
            gladLoadGL(osmesa().get_proc_address) == 0 || !GLAD_GL_VERSION_3_3) {
            osmesa().destroy(context_);
            throw RenderError("OSMesa's OpenGL 3.3 context cannot be made current", RenderFault::old_opengl);
        }
    }
    ~OsmesaContext() override {
        osmesa().make_current(nullptr, nullptr, 0, 0, 0);
        osmesa().destroy(context_);
    }

private:
    // The screen that OSMesa insists on; nothing is drawn there.
    static constexpr int side = 16;
    std::array<unsigned char, std::size_t{side} * side * 4> screen_{};
    OsmesaHandle context_ = nullptr;
};

}  // namespace

std::string GlContext::renderer() const {
    const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return text != nullptr ? on_one_line(text) : "unknown";
}

bool GlContext::is_software() const {
    const std::string name = renderer();
    for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR"}) {
        if (name.find(software) != std::string::npos) return true;
    }
    return false;
}

std::unique_ptr<GlContext> open_osmesa() { return std::make_unique<OsmesaContext>(); }

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

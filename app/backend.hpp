// Finding a renderer that works.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "base/timings.hpp"
#include "cpu/cpu_renderer.hpp"
#include "gpu/gpu_renderer.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

// A renderer that works. Without a context it is the CPU renderer.
struct OpenBackend {
    Backend backend = Backend::cpu;
    std::string description = "cpu";       // e.g. "egl (EGL device 0, llvmpipe ...)"
    std::vector<std::string> passed_over;  // better backends that failed, with the reasons
    std::unique_ptr<GlContext> context;    // declared before `gpu`, which must be destroyed first
    std::optional<GpuRenderer> gpu;
    TileCosts tile_costs = cpu_tile_costs;  // the renderer's
};

// Opens a backend: automatic tries EGL on hardware, EGL in software, OSMesa, CPU (on Windows WGL, CPU), each up to a drawn pixel.
// `device`: an EGL device by number. LIBGL_ALWAYS_SOFTWARE rules out hardware. A limit on the address space that is too low for a
// driver and `beside` rules out GL; `beside`: bytes that the caller needs while it draws. Throws RenderError when the named backend
// does not work, InputError for a device number that does not exist.
OpenBackend open_backend(Backend backend, std::optional<int> device, Timings& timings, std::uint64_t beside = 0);

}  // namespace sphereview

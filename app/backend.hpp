// Which renderer draws, and how it is found.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/timings.hpp"
#include "cpu/cpu_renderer.hpp"
#include "gpu/gpu_renderer.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

enum class Backend { automatic, egl, osmesa, cpu };

// "auto", "egl", "osmesa", "cpu".
std::string_view name_of(Backend backend);

// The backend of that name, or nothing.
std::optional<Backend> backend_named(std::string_view name);

// For messages: the names of all backends.
inline constexpr std::string_view backend_names = "auto, egl, osmesa or cpu";

// A renderer that was found to work. Without a context it is the CPU's.
struct OpenBackend {
    Backend backend = Backend::cpu;
    std::string description = "cpu";       // e.g. "egl (EGL device 0, llvmpipe ...)"
    std::vector<std::string> passed_over;  // each better one that failed, with the reason
    std::unique_ptr<GlContext> context;    // before `gpu`, which must be destroyed first
    std::optional<GpuRenderer> gpu;
    TileCosts tile_costs = cpu_tile_costs;  // the renderer's
};

// Opens what was asked for: automatic tries EGL on hardware, EGL in software, OSMesa, CPU; each through to a drawn pixel.
// `device` picks an EGL device by number. LIBGL_ALWAYS_SOFTWARE rules out hardware. Throws RenderError when the backend
// asked for does not work, InputError for a device number that does not exist.
OpenBackend open_backend(Backend backend, std::optional<int> device, Timings& timings);

}  // namespace sphereview

#include "app/backend.hpp"

#include <cstdlib>
#include <functional>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

bool hardware_ruled_out() {
    // Reads the variable as Mesa does.
    const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const std::string_view setting = value != nullptr ? value : "";
    return setting == "1" || setting == "true" || setting == "yes" || setting == "y" || setting == "t";
}

using OpenContext = std::function<std::unique_ptr<GlContext>()>;

// Opens a context and a renderer in it, and notes where; throws RenderError when either does not work.
void open_gl(OpenBackend& open, Backend backend, const std::string& where, const OpenContext& open_context, Timings& timings) {
    std::unique_ptr<GlContext> context = timed(timings, Phase::context, open_context);
    std::optional<GpuRenderer> gpu;
    gpu.emplace(timings);
    open.backend = backend;
    open.description = std::string(name_of(backend)) + " (" + where + ", " + context->renderer() + ")";
    open.gpu = std::move(gpu);
    open.tile_costs = gpu_tile_costs;
    open.context = std::move(context);
}

// Notes why where that does not work.
bool try_gl(OpenBackend& open, Backend backend, const std::string& where, const OpenContext& open_context, Timings& timings) {
    try {
        open_gl(open, backend, where, open_context, timings);
        return true;
    } catch (const RenderError& error) {
        open.passed_over.push_back(where + ": " + error.what());
        return false;
    }
}

void close(OpenBackend& open) {
    open.gpu.reset();
    open.context.reset();
    open.tile_costs = cpu_tile_costs;
}

// Hardware first, then software.
bool try_egl(OpenBackend& open, Timings& timings) {
    std::vector<EglDevice> devices;
    try {
        devices = timed(timings, Phase::context, list_egl_devices);
    } catch (const RenderError& error) {
        open.passed_over.push_back(std::string("EGL: ") + error.what());
        return false;
    }
    const auto try_device = [&](const EglDevice& device) {
        return try_gl(
            open, Backend::egl, device.name, [&] { return open_egl(device); }, timings);
    };
    const bool has_devices = !devices.empty() && devices.front().kind == EglDevice::Kind::device;
    std::vector<const EglDevice*> later;
    for (const EglDevice& device : devices) {
        // Without a list of devices, the other platforms may lead to hardware too.
        const bool perhaps_hardware = has_devices ? device.kind == EglDevice::Kind::device && !device.software : true;
        if (!perhaps_hardware || hardware_ruled_out()) {
            later.push_back(&device);
        } else if (try_device(device)) {
            if (!open.context->is_software()) return true;
            close(open);
            later.insert(later.begin(), &device);
        }
    }
    for (const EglDevice* device : later) {
        if (!try_device(*device)) continue;
        if (open.context->is_software() || !hardware_ruled_out()) return true;
        open.passed_over.push_back(device->name + ": it is hardware, which LIBGL_ALWAYS_SOFTWARE rules out");
        close(open);
    }
    if (devices.empty()) open.passed_over.push_back("EGL: it offers no device");
    return false;
}

// Whether automatic tries it on this system.
bool is_at_home(Backend backend) {
#ifdef _WIN32
    return backend == Backend::wgl;
#else
    return backend != Backend::wgl;
#endif
}

void open_numbered_device(OpenBackend& open, int number, Timings& timings) {
    const std::vector<EglDevice> devices = list_egl_devices();
    int count = 0;
    for (const EglDevice& device : devices) {
        if (device.kind != EglDevice::Kind::device) continue;
        if (count++ != number) continue;
        open_gl(
            open, Backend::egl, device.name, [&] { return open_egl(device); }, timings);
        return;
    }
    const std::string range = count == 0   ? "EGL lists no devices here"
                              : count == 1 ? "expected 0, the only EGL device"
                                           : "expected an EGL device from 0 to " + std::to_string(count - 1);
    throw InputError("sphereview: --device: found '" + std::to_string(number) + "', " + range + " (see 'sphereview doctor')");
}

}  // namespace

OpenBackend open_backend(Backend backend, std::optional<int> device, Timings& timings, std::uint64_t beside) {
    OpenBackend open;
    if (backend == Backend::cpu) return open;
    try {
        require_address_space_for_gl(beside);
    } catch (const RenderError& error) {
        if (device || backend != Backend::automatic) throw;
        open.passed_over.push_back(std::string("GL: ") + error.what());
        return open;
    }
    if (device) {
        open_numbered_device(open, *device, timings);
        return open;
    }
    const auto is_tried = [&](Backend one) { return backend == one || (backend == Backend::automatic && is_at_home(one)); };
    if (is_tried(Backend::wgl) && try_gl(open, Backend::wgl, "WGL", open_wgl, timings)) return open;
    if (is_tried(Backend::egl) && try_egl(open, timings)) return open;
    if (is_tried(Backend::osmesa) && try_gl(open, Backend::osmesa, "OSMesa", open_osmesa, timings)) return open;
    if (backend != Backend::automatic) {
        throw RenderError("the backend " + std::string(name_of(backend)) +
                          " does not work here: " + joined(open.passed_over, "; ") + " (see 'sphereview doctor')");
    }
    return open;
}

}  // namespace sphereview

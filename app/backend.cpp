#include "app/backend.hpp"

#include <array>
#include <cstdlib>
#include <functional>

#include "base/error.hpp"

namespace sphereview {

namespace {

constexpr std::array<std::pair<Backend, std::string_view>, 4> names = {
    {{Backend::automatic, "auto"}, {Backend::egl, "egl"}, {Backend::osmesa, "osmesa"}, {Backend::cpu, "cpu"}}};

bool hardware_ruled_out() {
    // As Mesa reads it.
    const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    const std::string_view setting = value != nullptr ? value : "";
    return setting == "1" || setting == "true" || setting == "yes" || setting == "y" || setting == "t";
}

// Opens a context and a renderer in it, and notes where; throws RenderError when either does not work.
void open_gl(OpenBackend& open, Backend backend, const std::string& where,
             const std::function<std::unique_ptr<GlContext>()>& open_context, Timings& timings) {
    std::unique_ptr<GlContext> context;
    {
        const PhaseTimer timer(timings, Phase::context);
        context = open_context();
    }
    std::optional<GpuRenderer> gpu;
    gpu.emplace(timings);
    open.backend = backend;
    open.description = std::string(name_of(backend)) + " (" + where + ", " + context->renderer() + ")";
    open.gpu = std::move(gpu);
    open.tile_costs = gpu_tile_costs;
    open.context = std::move(context);
}

void close(OpenBackend& open) {
    open.gpu.reset();
    open.context.reset();
    open.tile_costs = cpu_tile_costs;
}

bool try_egl_device(OpenBackend& open, const EglDevice& device, Timings& timings) {
    try {
        open_gl(
            open, Backend::egl, device.name, [&] { return open_egl(device); }, timings);
        return true;
    } catch (const RenderError& error) {
        open.passed_over.push_back(device.name + ": " + error.what());
        return false;
    }
}

// Hardware first, then software.
bool try_egl(OpenBackend& open, Timings& timings) {
    std::vector<EglDevice> devices;
    try {
        const PhaseTimer timer(timings, Phase::context);
        devices = list_egl_devices();
    } catch (const RenderError& error) {
        open.passed_over.push_back(std::string("EGL: ") + error.what());
        return false;
    }
    const bool has_devices = !devices.empty() && devices.front().kind == EglDevice::Kind::device;
    std::vector<const EglDevice*> later;
    for (const EglDevice& device : devices) {
        // Without a list of devices, the other platforms may lead to hardware too.
        const bool perhaps_hardware = has_devices ? device.kind == EglDevice::Kind::device && !device.software : true;
        if (!perhaps_hardware || hardware_ruled_out()) {
            later.push_back(&device);
        } else if (try_egl_device(open, device, timings)) {
            if (!open.context->is_software()) return true;
            close(open);
            later.insert(later.begin(), &device);
        }
    }
    for (const EglDevice* device : later) {
        if (!try_egl_device(open, *device, timings)) continue;
        if (open.context->is_software() || !hardware_ruled_out()) return true;
        open.passed_over.push_back(device->name + ": it is hardware, which LIBGL_ALWAYS_SOFTWARE rules out");
        close(open);
    }
    if (devices.empty()) open.passed_over.push_back("EGL: it offers no device");
    return false;
}

bool try_osmesa(OpenBackend& open, Timings& timings) {
    try {
        open_gl(open, Backend::osmesa, "OSMesa", open_osmesa, timings);
        return true;
    } catch (const RenderError& error) {
        open.passed_over.push_back(std::string("OSMesa: ") + error.what());
        return false;
    }
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

std::string joined(const std::vector<std::string>& reasons) {
    std::string text;
    for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
    return text;
}

}  // namespace

std::string_view name_of(Backend backend) {
    for (const auto& [value, name] : names) {
        if (value == backend) return name;
    }
    return "";
}

std::optional<Backend> backend_named(std::string_view name) {
    for (const auto& [value, known] : names) {
        if (known == name) return value;
    }
    return std::nullopt;
}

OpenBackend open_backend(Backend backend, std::optional<int> device, Timings& timings, std::uint64_t beside) {
    OpenBackend open;
    if (backend == Backend::cpu) return open;
    try {
        require_address_space_for_gl(beside);
    } catch (const RenderError& error) {
        if (device || backend != Backend::automatic) throw;
        open.passed_over.push_back(std::string("EGL and OSMesa: ") + error.what());
        return open;
    }
    if (device) {
        open_numbered_device(open, *device, timings);
        return open;
    }
    if (backend != Backend::osmesa && try_egl(open, timings)) return open;
    if (backend != Backend::egl && try_osmesa(open, timings)) return open;
    if (backend != Backend::automatic) {
        throw RenderError("the backend " + std::string(name_of(backend)) + " does not work here: " + joined(open.passed_over) +
                          " (see 'sphereview doctor')");
    }
    return open;
}

}  // namespace sphereview

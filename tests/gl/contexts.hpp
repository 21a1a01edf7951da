// Contexts for tests that call the GPU renderer themselves.
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "platform/gl_context.hpp"

namespace sphereview::test {

struct ContextKind {
    std::string name;
    std::function<std::unique_ptr<GlContext>()> open;
};

// How a failed test names it.
inline std::ostream& operator<<(std::ostream& stream, const ContextKind& kind) { return stream << kind.name; }

// EGL's first device, and OSMesa.
inline std::vector<ContextKind> context_kinds() {
    return {{"Egl", [] { return open_egl(list_egl_devices().at(0)); }}, {"Osmesa", open_osmesa}};
}

}  // namespace sphereview::test

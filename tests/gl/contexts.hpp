// Contexts for tests that call the GPU renderer themselves.
#pragma once

#include <gtest/gtest.h>

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

// A test in each of them: INSTANTIATE_TEST_SUITE_P(Contexts, NAME, testing::ValuesIn(context_kinds()),
// testing::PrintToStringParamName());
class InContext : public testing::TestWithParam<ContextKind> {
protected:
    std::unique_ptr<GlContext> context_ = GetParam().open();
};

}  // namespace sphereview::test

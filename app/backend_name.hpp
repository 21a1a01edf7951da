// The renderers that a person can ask for. Apart from backend.hpp, so that options need no renderer.
#pragma once

#include <optional>
#include <string_view>

namespace sphereview {

enum class Backend { automatic, egl, osmesa, cpu };

// "auto", "egl", "osmesa", "cpu".
std::string_view name_of(Backend backend);

// The backend of that name, or nothing.
std::optional<Backend> backend_named(std::string_view name);

// For messages: the names of all backends.
inline constexpr std::string_view backend_names = "auto, egl, osmesa or cpu";

}  // namespace sphereview

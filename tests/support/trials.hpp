// How many random trials a test does, and from which seed.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace sphereview::test {

#ifdef SPHEREVIEW_SANITIZED
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

// A quarter of `count` with sanitizers, with which each trial takes several times as long.
constexpr int trials(int count) { return is_sanitized ? (count + 3) / 4 : count; }

// A number that a person sets to try other inputs; SPHEREVIEW_SEED is one.
inline std::uint64_t number_from_environment(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace sphereview::test

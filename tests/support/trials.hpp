// How many random trials a test does, and from which seed.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace sphereview::test {

// A quarter of `count` with sanitizers, with which each trial takes several times as long.
#ifdef SPHEREVIEW_SANITIZED
constexpr int trials(int count) { return (count + 3) / 4; }
#else
constexpr int trials(int count) { return count; }
#endif

// A number that a person sets to try other inputs; SPHEREVIEW_SEED is one.
inline std::uint64_t number_from_environment(const char* variable, std::uint64_t otherwise) {
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace sphereview::test

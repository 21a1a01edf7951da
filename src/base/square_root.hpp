// The square root with the same bits everywhere.
#pragma once

#include <cmath>

namespace sphereview {

// Correctly rounded, as IEEE 754 asks, on every system and with any flags. The library function of mingw-w64 rounds twice; with
// -fno-math-errno (cmake/options.cmake) the compiler's builtin is the processor's instruction, and loops with it become SIMD. `x`
// >= 0.
inline double square_root(double x) {
#ifdef __GNUC__
    return __builtin_sqrt(x);
#else
    return std::sqrt(x);
#endif
}
inline float square_root(float x) {
#ifdef __GNUC__
    return __builtin_sqrtf(x);
#else
    return std::sqrt(x);
#endif
}

}  // namespace sphereview

// The one square root whose every bit counts.
#pragma once

#include <cmath>

namespace sphereview {

// Correctly rounded, as IEEE 754 asks, wherever and however it is compiled. The library function of mingw-w64 rounds twice; with
// -fno-math-errno (cmake/options.cmake) the compiler's own is the processor's instruction at every level of optimisation, and loops
// with it still become SIMD. `x` >= 0.
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

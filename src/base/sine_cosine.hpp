// The sine and cosine whose every bit counts.
#pragma once

namespace sphereview {

// Of a finite angle in degrees, each within 2^-51 of its size or 2^-52, and exact at multiples of 90. The same doubles on every
// machine, for they are made by + - * / in a fixed order.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};
SineCosine sine_cosine(double degrees);

}  // namespace sphereview

// Sine and cosine with the same bits everywhere.
#pragma once

namespace sphereview {

// `degrees`: finite. Both results are within 2^-51 of their size or 2^-52, and exact at multiples of 90. The same doubles on every
// machine, because they are made by + - * / in a fixed order.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};
SineCosine sine_cosine(double degrees);

}  // namespace sphereview

// The logarithm whose every bit counts.
#pragma once

namespace sphereview {

// To base 2, of a finite number above 0, within 2^-50 of its size or 2^-52; exact for powers of two. The same double on every
// machine, for it is made by + - * / in a fixed order.
double binary_logarithm(double x);

}  // namespace sphereview

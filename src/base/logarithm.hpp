// The logarithm with the same bits everywhere.
#pragma once

namespace sphereview {

// To base 2, of a finite number above 0; within 2^-50 of its size or 2^-52, and exact for powers of two. The same double on every
// machine, because it is made by + - * / in a fixed order.
double binary_logarithm(double x);

}  // namespace sphereview

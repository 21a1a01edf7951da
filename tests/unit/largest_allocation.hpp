// Sees what a program allocates: linking largest_allocation.cpp replaces operator new.
#pragma once

#include <cstddef>

namespace sphereview {

// The largest allocation since the last call, in bytes.
std::size_t take_largest_allocation();

}  // namespace sphereview

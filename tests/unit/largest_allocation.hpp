// Sees what a program allocates: linking largest_allocation.cpp replaces operator new.
#pragma once

#include <cstddef>

namespace sphereview {

// The largest allocation since the last call, in bytes.
std::size_t take_largest_allocation();

// The most bytes that were allocated at one time since begin_most_bytes(), beyond those of then. 0 where the system does not tell
// how large a piece of memory is (only Linux does).
void begin_most_bytes();
std::size_t most_bytes();

}  // namespace sphereview

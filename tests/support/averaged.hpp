// What anti-aliasing must give, in a few lines of its own.
#pragma once

#include "support/picture.hpp"

namespace sphereview::test {

// The average of each side x side pixels: halves rounded up; with alpha, colours weighted by it.
Picture averaged(const Picture& points, int side);

}  // namespace sphereview::test

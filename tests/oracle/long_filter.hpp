// A filter for pictures that are too large for whole numbers at every pixel: long double with a bound that a computer
// carries along, and the oracle where that does not decide. Shares nothing with src/exact.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview::oracle {

struct FilteredPicture {
    std::vector<std::int32_t> numbers;  // as picture() has them
    std::size_t by_the_oracle = 0;      // pixels that long double did not decide
};

FilteredPicture filtered_picture(const Scene& scene, PictureSize size);

}  // namespace sphereview::oracle

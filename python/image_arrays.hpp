// Pictures as NumPy's arrays (height, width, 3 or 4) of bytes, and back.
#pragma once

#include <pybind11/numpy.h>

#include "image/image.hpp"

namespace sphereview {

// An array that owns the picture's memory: nothing is copied.
pybind11::array array_of(Image&& image);

// A copy. Throws InputError for an array of another shape.
Image image_from(const pybind11::array_t<std::uint8_t, pybind11::array::c_style>& array);

}  // namespace sphereview

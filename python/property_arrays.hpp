// What a file holds of each sphere, as NumPy's arrays.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "formats/sphere_data.hpp"
#include "scene/property.hpp"

namespace sphereview {

// By their names, in the order of the scene, those that `asked` asks for: double or float where they are numbers, NaN where a
// sphere has none; int32, or double where a sphere has none; of words Python's strings, each kept once, "" where a sphere has none.
// The numbers are moved, not copied.
pybind11::dict values_of(std::vector<Property>&& properties, const DataOptions& asked);

}  // namespace sphereview

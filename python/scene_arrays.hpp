// Scenes from NumPy's arrays and back.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <optional>

#include "camera/fit.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A camera as Python passes it: eye, center, right and up, three numbers each, and the projection's value.
using CameraNumbers = std::array<double, 13>;

// Throws InputError for a camera that nothing can be seen with.
Camera camera_from(const CameraNumbers& numbers);
CameraNumbers numbers_of(const Camera& camera);

// The spheres as arrays whose elements lie one behind the other: centers N x 3, radii N, hidden N, and colors N x 3 of bytes, of
// int64 or of doubles from 0 to 1.
struct SphereArrays {
    pybind11::array_t<double, pybind11::array::c_style> centers;
    pybind11::array_t<double, pybind11::array::c_style> radii;
    pybind11::array colors;
    std::optional<pybind11::array_t<bool, pybind11::array::c_style>> hidden;
};

// Reads the arrays in place, on all cores and without Python's lock. Throws InputError "centers[1, 2]: found ..., expected ..."
// with the words that readers of files have, and MemoryError when the spheres cannot fit.
Scene scene_from(const SphereArrays& arrays);

// New arrays: bytes for colors, and hidden only where a sphere is.
SphereArrays arrays_of(const Scene& scene);

}  // namespace sphereview

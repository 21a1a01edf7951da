// Whether two scenes are the same bit for bit.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace sphereview {

// What is first different, and both values as hexadecimal floats; "" for scenes that are the same. Unlike with operator==,
// -0 differs from 0.
std::string difference(const Scene& actual, const Scene& expected);

// What is left of a scene in the text format.
Scene without_extras(const Scene& scene);

}  // namespace sphereview

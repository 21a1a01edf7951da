// Texts that hold nothing but points, a line each.
#pragma once

#include <string_view>

namespace sphereview {

// Whether a text that begins so, under a name for XYZ, is a table of points and no frame of atoms (sphere_data.hpp, read_csv()):
// its first lines are rows of as many numbers each, perhaps behind their number, or a header or commas show it. A frame begins with
// a number of atoms, and the lines behind it are others.
bool shows_points(std::string_view head);

}  // namespace sphereview

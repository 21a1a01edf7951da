// Texts of points alone, a line each.
#pragma once

#include <string_view>

namespace sphereview {

// Whether a text with the beginning `head` and a name for XYZ is a table of points (sphere_data.hpp, read_csv()) and no frame of
// atoms: its first lines are rows of equally many numbers, perhaps behind the number of rows, or a header or commas show it.
bool shows_points(std::string_view head);

}  // namespace sphereview

// Texts that hold nothing but points, a line each.
#pragma once

#include <string>
#include <string_view>

#include "formats/sphere_data.hpp"

namespace sphereview {

// Whether the text is nothing but points: its first lines have as many words each, of which the first three are numbers. A frame
// begins with a number of atoms, and the lines behind it are others.
bool is_bare_points(std::string_view text);

// A line `x y z ...` for each point; what stands behind is passed over, and so are comments. The radius is the given one, or made
// of the points' distances. Throws as SceneFormat::read.
SphereData read_points(std::string_view text, const std::string& name, const DataOptions& options);

}  // namespace sphereview

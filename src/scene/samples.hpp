// Anti-aliasing: a pixel is the average of points on a regular grid in it.
#pragma once

#include <array>

#include "scene/camera.hpp"

namespace sphereview {

// How many points a pixel may have; the first is the default.
inline constexpr std::array<int, 3> sample_counts = {1, 4, 16};
inline constexpr const char* sample_counts_text = "1, 4 or 16";

// Of the grid in a pixel: samples = side x side.
constexpr int sample_side(int samples) { return samples == 16 ? 4 : samples == 4 ? 2 : 1; }

// The points of a picture are, exactly, the centres of the pixels of the same camera's picture of `side` times the size: point
// (i, j) of pixel (x, y) is pixel (side x + i, side y + j) there, and m and the rays' coefficients (scene/camera.hpp) scale alike.
// So whatever holds for pixels holds for points.
constexpr PictureSize sampled_size(PictureSize size, int side) { return {size.width * side, size.height * side}; }

}  // namespace sphereview

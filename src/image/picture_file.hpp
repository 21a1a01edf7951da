// Pictures that other programs wrote.
#pragma once

#include <string>
#include <vector>

#include "image/image.hpp"

namespace sphereview {

inline const std::vector<std::string> picture_endings = {".png", ".ppm", ".pgm", ".bmp"};  // of those that are read

// The picture in a PNG, a PPM or PGM (as text or binary) or a BMP, told apart by their first bytes: RGB, or RGBA where there is
// alpha; the file at `path`, or standard input for "-". Throws InputError for anything else and for a damaged one, and MemoryError
// when it cannot fit.
Image read_picture(const std::string& path);

}  // namespace sphereview

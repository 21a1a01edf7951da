// Pictures that other programs wrote.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace sphereview {

inline const std::vector<std::string> picture_endings = {".png", ".ppm", ".pgm", ".bmp"};  // of those that are read

// The picture in a PNG, a PPM or PGM (as text or binary) or a BMP, told apart by their first bytes: RGB, or RGBA where there is
// alpha. `name`: how messages call the file. Throws InputError for anything else and for a damaged one, and MemoryError when it
// cannot fit.
Image decode_picture(std::string_view bytes, const std::string& name);

// The same of the file at `path`, or of standard input for "-".
Image read_picture(const std::string& path);

}  // namespace sphereview

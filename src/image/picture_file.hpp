// Reads pictures of other programs.
#pragma once

#include <string>
#include <string_view>

#include "image/image.hpp"

namespace sphereview {

// The picture in a PNG, PPM, PGM (text or binary) or BMP, told apart by the first bytes: RGB, or RGBA with alpha. `name`: for
// messages. Throws InputError for other or damaged files, and MemoryError when the picture cannot fit.
Image decode_picture(std::string_view bytes, const std::string& name);

// The same of the file at `path`, or of standard input for "-".
Image read_picture(const std::string& path);

}  // namespace sphereview

// stb_image_write as it comes, to compare the project's PNG encoder with.
#pragma once

#include <string>

#include "image/image.hpp"

namespace sphereview {

// The picture as a PNG from stb's own filters and compressor.
std::string encode_png_stb(const Image& image);

}  // namespace sphereview

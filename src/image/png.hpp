// PNG files.
#pragma once

#include <string>
#include <string_view>

#include "image/image.hpp"

namespace sphereview {

// The picture as an 8-bit RGB or RGBA PNG; the same bytes for the same picture on the same
// kind of processor, whose instructions the compressor uses. At most `most_pixels`.
// Throws std::bad_alloc when memory does not suffice.
std::string encode_png(const Image& image);

// Reads a PNG of any kind as 8-bit RGB, or RGBA where it has transparency; 16-bit channels are refused rather than rounded.
// `name` is how messages call it. Throws InputError.
Image decode_png(std::string_view bytes, const std::string& name);

}  // namespace sphereview

// Pictures as an uncompressed film, which every encoder reads (YUV4MPEG2), in whole numbers.
#pragma once

#include <string>

#include "image/image.hpp"

namespace sphereview {

// Pictures a second, as a fraction.
struct FrameRate {
    int pictures = 30;
    int seconds = 1;

    bool operator==(const FrameRate&) const = default;
};

// The beginning of such a film.
std::string y4m_head(int width, int height, FrameRate rate);

// One picture of it; alpha is left out. Of each pixel, by ITU-R BT.709 with luma from 16 to 235, with halves rounded up:
//   Y  = (11966 R + 40254 G +  4064 B +   16 * 65536 + 32768) >> 16
//   Cb = (-6596 R - 22188 G + 28784 B +  128 * 65536 + 32768) >> 16
//   Cr = (28784 R - 26145 G -  2639 B +  128 * 65536 + 32768) >> 16
std::string y4m_frame(const Image& picture);

}  // namespace sphereview

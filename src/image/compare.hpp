// Whether two pictures are the same, and where they are not.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "image/image.hpp"

namespace sphereview {

struct Comparison {
    bool same_size = true;
    std::int64_t different_pixels = 0;
    std::array<int, 4> largest{};  // per channel R, G, B, A: the largest difference, 0..255
    int first_x = 0;               // the first different pixel, in reading order
    int first_y = 0;

    bool equal() const { return same_size && different_pixels == 0; }
};

// Compares byte for byte; a picture without alpha counts as opaque.
Comparison compare(const Image& actual, const Image& expected);

// One line: how many pixels differ, how far, where the first is; or the two sizes.
std::string describe(const Comparison& comparison, const Image& actual, const Image& expected);

// A picture of the difference: equal pixels as the actual picture dimmed to a quarter, different ones white; where only
// one picture reaches, magenta. As large as both pictures together.
Image difference_picture(const Image& actual, const Image& expected);

}  // namespace sphereview

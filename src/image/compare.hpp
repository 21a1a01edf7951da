// Compares two pictures.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "image/image.hpp"
#include "image/png.hpp"

namespace sphereview {

// Red, green, blue and alpha.
using Rgba = std::array<int, 4>;

struct Comparison {
    std::array<int, 2> size{};  // width and height of the actual picture
    std::array<int, 2> expected_size{};
    std::int64_t different_pixels = 0;  // of pictures of the same size
    Rgba largest{};                     // the largest difference of each channel, 0..255
    int first_x = 0;                    // the first different pixel, in reading order
    int first_y = 0;
    Rgba first{};  // its colour
    Rgba first_expected{};

    bool same_size() const { return size == expected_size; }
    bool equal() const { return same_size() && different_pixels == 0; }
};

// Compares byte for byte; a picture without alpha counts as opaque.
Comparison compare(const Image& actual, const Image& expected);

// The same with a file, of which only a row is in memory at a time; a file of another size is not read. `difference`, if not null,
// becomes a picture as large as both together: equal pixels dimmed to a quarter, different ones white, magenta where only one
// picture reaches. Throws as PngReader::read, InputError if that picture is too large, and MemoryError when it cannot fit.
Comparison compare(const Image& actual, PngReader& expected, Image* difference = nullptr);

// One line: how many pixels differ, how far, where the first is; or the two sizes.
std::string describe(const Comparison& comparison);

}  // namespace sphereview

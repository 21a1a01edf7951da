// PNG files as the tests read and make them: with libpng, which shares no code with the program's own writer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sphereview::test {

// 8-bit pixels, top row first, without padding; 3 (RGB) or 4 (RGBA) channels.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::string bytes;

    // The channels of pixel (x, y), (0, 0) at the top left.
    std::vector<int> at(int x, int y) const;
    bool operator==(const Picture&) const = default;
};

// A picture of one colour; as many channels as the colour has.
Picture plain_picture(int width, int height, const std::vector<int>& color);

// Decodes a PNG, RGBA where the file has alpha. Fails the test and returns an empty picture when it is none.
Picture decode_png(std::string_view file);

// As the bytes of a PNG file.
std::string encode_png(const Picture& picture);

// What anti-aliasing must give: the average of each side x side pixels, halves rounded up; with alpha, colours weighted by it.
Picture averaged(const Picture& points, int side);

}  // namespace sphereview::test

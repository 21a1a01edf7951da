#include "image/y4m.hpp"

#include <cstddef>
#include <cstdint>

namespace sphereview {

namespace {

constexpr int one = 1 << 16;

struct Weights {
    int red;
    int green;
    int blue;
    int origin;  // of black
};

constexpr Weights luma{11966, 40254, 4064, 16};
constexpr Weights blue_difference{-6596, -22188, 28784, 128};
constexpr Weights red_difference{28784, -26145, -2639, 128};

void append_plane(std::string& bytes, const Image& picture, const Weights& weights) {
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* pixel = picture.at(0, y);
        for (int x = 0; x < picture.width(); ++x, pixel += picture.channels()) {
            const int sum = weights.red * pixel[0] + weights.green * pixel[1] + weights.blue * pixel[2];
            bytes += static_cast<char>((sum + weights.origin * one + one / 2) >> 16);
        }
    }
}

}  // namespace

std::string y4m_head(int width, int height, FrameRate rate) {
    return "YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F" + std::to_string(rate.pictures) + ":" +
           std::to_string(rate.seconds) + " Ip A1:1 C444 XCOLORRANGE=LIMITED\n";
}

std::string y4m_frame(const Image& picture) {
    std::string bytes = "FRAME\n";
    bytes.reserve(bytes.size() + 3 * static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()));
    append_plane(bytes, picture, luma);
    append_plane(bytes, picture, blue_difference);
    append_plane(bytes, picture, red_difference);
    return bytes;
}

}  // namespace sphereview

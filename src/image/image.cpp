#include "image/image.hpp"

#include <array>
#include <cassert>

#include "base/parallel.hpp"

namespace sphereview {

namespace {

std::uint8_t rounded(unsigned sum, unsigned count) { return static_cast<std::uint8_t>((sum + count / 2) / count); }

// `from` points at the first point of the pixel; rows of points are `stride` bytes apart.
template <unsigned side>
void average_opaque(const std::uint8_t* from, std::size_t stride, std::uint8_t* pixel) {
    std::array<unsigned, 3> sums{};
    for (unsigned row = 0; row < side; ++row, from += stride) {
        for (unsigned i = 0; i < 3 * side; ++i) sums[i % 3] += from[i];
    }
    for (unsigned channel = 0; channel < 3; ++channel) pixel[channel] = rounded(sums[channel], side * side);
}

template <unsigned side>
void average_alpha(const std::uint8_t* from, std::size_t stride, std::uint8_t* pixel) {
    std::array<unsigned, 4> sums{};
    for (unsigned row = 0; row < side; ++row, from += stride) {
        for (const std::uint8_t* point = from; point != from + std::size_t{4} * side; point += 4) {
            const unsigned alpha = point[3];
            for (unsigned channel = 0; channel < 3; ++channel) sums[channel] += alpha * point[channel];
            sums[3] += alpha;
        }
    }
    pixel[3] = rounded(sums[3], side * side);
    for (unsigned channel = 0; channel < 3; ++channel) pixel[channel] = pixel[3] == 0 ? 0 : rounded(sums[channel], sums[3]);
}

template <unsigned side>
void average_all(const Image& points, Image& picture, int x, int y) {
    const auto channels = static_cast<std::size_t>(points.channels());
    const auto across = static_cast<std::size_t>(points.width()) / side;
    const std::size_t stride = static_cast<std::size_t>(points.width()) * channels;
    parallel_for(static_cast<std::size_t>(points.height()) / side, [&](std::size_t row) {
        const std::uint8_t* from = points.at(0, static_cast<int>(row * side));
        std::uint8_t* pixel = picture.at(x, y + static_cast<int>(row));
        for (std::size_t i = 0; i < across; ++i, from += side * channels, pixel += channels) {
            if (channels == 4) {
                average_alpha<side>(from, stride, pixel);
            } else {
                average_opaque<side>(from, stride, pixel);
            }
        }
    });
}

}  // namespace

void average_into(const Image& points, int side, Image& picture, int x, int y) {
    assert(points.channels() == picture.channels() && points.width() % side == 0 && points.height() % side == 0);
    assert(x + points.width() / side <= picture.width() && y + points.height() / side <= picture.height());
    switch (side) {
        case 1: return average_all<1>(points, picture, x, y);
        case 2: return average_all<2>(points, picture, x, y);
        case 4: return average_all<4>(points, picture, x, y);
        default: assert(false);
    }
}

}  // namespace sphereview

// A picture of 8-bit pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace sphereview {

// Width x height pixels of 3 (RGB) or 4 (RGBA) bytes, top row first, without padding. Begins with unspecified bytes.
class Image {
public:
    Image() = default;
    Image(int width, int height, int channels)
        : width_(width),
          height_(height),
          channels_(channels),
          bytes_(std::make_unique_for_overwrite<std::uint8_t[]>(size_of(width, height, channels))) {}

    Image copy() const {
        Image other(width_, height_, channels_);
        std::copy_n(bytes_.get(), bytes().size(), other.bytes_.get());
        return other;
    }

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }

    std::span<std::uint8_t> bytes() { return {bytes_.get(), size_of(width_, height_, channels_)}; }
    std::span<const std::uint8_t> bytes() const { return {bytes_.get(), size_of(width_, height_, channels_)}; }

    // The bytes of pixel (x, y), (0, 0) at the top left.
    std::uint8_t* at(int x, int y) { return bytes_.get() + size_of(width_, y, channels_) + size_of(x, 1, channels_); }
    const std::uint8_t* at(int x, int y) const { return bytes_.get() + size_of(width_, y, channels_) + size_of(x, 1, channels_); }

private:
    static std::size_t size_of(int width, int height, int channels) {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
    }

    int width_ = 0;
    int height_ = 0;
    int channels_ = 3;
    std::unique_ptr<std::uint8_t[]> bytes_;
};

// The most pixels a picture may have: the PNG writer counts its bytes, 4 a pixel and one a row, in 31 bits.
inline constexpr std::int64_t most_pixels = (std::int64_t{1} << 31) / 5;

// Sets each pixel of a part of `picture`, whose corner is (x, y), to the average of side x side pixels of `points`, which has
// `side` times the part's size and as many channels. side: 1, 2 or 4. Whole numbers, halves rounded up: round(sum / n) of the
// stored bytes. With alpha, a: round(sum a / n), and each colour counts as much as its point covers: round(sum (a colour) / sum a);
// where a is 0, all is 0. The average is of the stored bytes, not of linear light: a scene's colours are numbers without a colour
// space. Anyone can check an average, or make another one from the larger picture.
void average_into(const Image& points, int side, Image& picture, int x, int y);

}  // namespace sphereview

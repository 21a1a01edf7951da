#include "image/compare.hpp"

#include <algorithm>
#include <cstdlib>

namespace sphereview {

namespace {

using Rgba = std::array<int, 4>;

Rgba rgba(const Image& image, int x, int y) {
    const std::uint8_t* bytes = image.at(x, y);
    return {bytes[0], bytes[1], bytes[2], image.channels() == 4 ? bytes[3] : 255};
}

}  // namespace

Comparison compare(const Image& actual, const Image& expected) {
    Comparison result;
    if (actual.width() != expected.width() || actual.height() != expected.height()) {
        result.same_size = false;
        return result;
    }
    if (actual.channels() == expected.channels() && std::ranges::equal(actual.bytes(), expected.bytes())) return result;
    for (int y = 0; y < actual.height(); ++y) {
        for (int x = 0; x < actual.width(); ++x) {
            const Rgba a = rgba(actual, x, y);
            const Rgba b = rgba(expected, x, y);
            if (a == b) continue;
            if (result.different_pixels == 0) {
                result.first_x = x;
                result.first_y = y;
            }
            ++result.different_pixels;
            for (std::size_t c = 0; c < 4; ++c) result.largest[c] = std::max(result.largest[c], std::abs(a[c] - b[c]));
        }
    }
    return result;
}

std::string describe(const Comparison& comparison, const Image& actual, const Image& expected) {
    const auto size = [](const Image& image) { return std::to_string(image.width()) + "x" + std::to_string(image.height()); };
    if (!comparison.same_size) return "the picture is " + size(actual) + ", expected " + size(expected);
    if (comparison.equal()) return "the pictures are equal";
    const auto pixels = static_cast<std::int64_t>(actual.width()) * actual.height();
    std::string text = std::to_string(comparison.different_pixels) + " of " + std::to_string(pixels) + " pixels differ, by at most";
    constexpr std::array<const char*, 4> channels = {" R ", " G ", " B ", " A "};
    for (std::size_t c = 0; c < 4; ++c) {
        if (c == 3 && comparison.largest[c] == 0) break;  // alpha concerns few
        text += channels[c] + std::to_string(comparison.largest[c]);
    }
    const Rgba a = rgba(actual, comparison.first_x, comparison.first_y);
    const Rgba b = rgba(expected, comparison.first_x, comparison.first_y);
    const auto color = [&](const Rgba& c) {
        std::string value = "(";
        for (std::size_t i = 0; i < (comparison.largest[3] == 0 ? 3U : 4U); ++i) {
            value += (i == 0 ? "" : ", ") + std::to_string(c[i]);
        }
        return value + ")";
    };
    return text + "; the first at pixel " + std::to_string(comparison.first_x) + "," + std::to_string(comparison.first_y) +
           ": found " + color(a) + ", expected " + color(b);
}

Image difference_picture(const Image& actual, const Image& expected) {
    const auto inside = [](const Image& image, int x, int y) { return x < image.width() && y < image.height(); };
    Image picture(std::max(actual.width(), expected.width()), std::max(actual.height(), expected.height()), 3);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            std::uint8_t* out = picture.at(x, y);
            if (!inside(actual, x, y) || !inside(expected, x, y)) {
                out[0] = out[2] = 255;
                out[1] = 0;
            } else if (const Rgba a = rgba(actual, x, y); a == rgba(expected, x, y)) {
                for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(a[c] / 4);
            } else {
                out[0] = out[1] = out[2] = 255;
            }
        }
    }
    return picture;
}

}  // namespace sphereview

#include "support/picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace sphereview::test {

std::vector<int> Picture::at(int x, int y) const {
    std::vector<int> color;
    const auto first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                       static_cast<std::size_t>(channels);
    for (int c = 0; c < channels; ++c) color.push_back(static_cast<unsigned char>(bytes.at(first + static_cast<std::size_t>(c))));
    return color;
}

Picture plain_picture(int width, int height, const std::vector<int>& color) {
    Picture picture{width, height, static_cast<int>(color.size()), ""};
    for (int i = 0; i < width * height; ++i) {
        for (const int channel : color) picture.bytes += static_cast<char>(channel);
    }
    return picture;
}

Picture decode_png(std::string_view file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) {
        ADD_FAILURE() << "not a PNG: " << image.message;
        return {};
    }
    const bool alpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    image.format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), alpha ? 4 : 3, ""};
    picture.bytes.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, picture.bytes.data(), 0, nullptr) == 0) {
        ADD_FAILURE() << "a broken PNG: " << image.message;
        return {};
    }
    return picture;
}

std::string encode_png(const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = picture.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string file(size, '\0');
    if (png_image_write_to_memory(&image, file.data(), &size, 0, picture.bytes.data(), 0, nullptr) == 0) {
        throw std::runtime_error(image.message);
    }
    file.resize(size);
    return file;
}

Picture averaged(const Picture& points, int side) {
    Picture picture{points.width / side, points.height / side, points.channels, ""};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            std::array<double, 3> color{};  // whole numbers, all of them
            double cover = 0.0;
            for (int i = 0; i < side * side; ++i) {
                const std::vector<int> point = points.at(x * side + i % side, y * side + i / side);
                const double alpha = point.size() == 4 ? point[3] : 255;
                for (std::size_t c = 0; c < 3; ++c) color[c] += alpha * point[c];
                cover += alpha;
            }
            const double alpha = std::floor(cover / (side * side) + 0.5);
            for (const double sum : color) {
                picture.bytes += static_cast<char>(alpha == 0.0 ? 0 : static_cast<int>(std::floor(sum / cover + 0.5)));
            }
            if (picture.channels == 4) picture.bytes += static_cast<char>(static_cast<int>(alpha));
        }
    }
    return picture;
}

}  // namespace sphereview::test

#include "stb_default.hpp"

// Static: the project's own copy, with another compressor, is linked into the same program.
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace sphereview {

std::string encode_png_stb(const Image& image) {
    std::string bytes;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    };
    stbi_write_png_to_func(append, &bytes, image.width(), image.height(), image.channels(), image.bytes().data(), 0);
    return bytes;
}

}  // namespace sphereview

#include "image/png.hpp"

#include <stb_image_write.h>

#include <cassert>
#include <new>

namespace sphereview {

namespace {

// stb's callback: appends to the std::string behind `context`.
void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string encode_png(const Image& image) {
    assert(static_cast<std::int64_t>(image.width()) * image.height() <= most_pixels);
    // No filter: rows of flat colours compress best as they are, and trying all five costs more than compressing.
    stbi_write_force_png_filter = 0;
    std::string bytes;
    const int done =
        stbi_write_png_to_func(append, &bytes, image.width(), image.height(), image.channels(), image.bytes().data(), 0);
    if (done == 0) throw std::bad_alloc();
    return bytes;
}

}  // namespace sphereview

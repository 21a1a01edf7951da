#include "image/png.hpp"

#include <stb_image.h>
#include <stb_image_write.h>

#include <cassert>
#include <cstring>
#include <memory>
#include <new>

#include "base/error.hpp"

namespace sphereview {

namespace {

// stb's callback: appends to the std::string behind `context`.
void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string encode_png(const Image& image) {
    assert(static_cast<std::int64_t>(image.width()) * image.height() <= most_pixels);
    // Filter 2, the difference to the row above, turns a flat picture into zeros; trying all five costs most of the time.
    stbi_write_force_png_filter = 2;
    std::string bytes;
    const int done = stbi_write_png_to_func(append, &bytes, image.width(), image.height(), image.channels(), image.bytes().data(), 0);
    if (done == 0) throw std::bad_alloc();
    return bytes;
}

Image decode_png(std::string_view bytes, const std::string& name) {
    const auto fail = [&](const std::string& why) { throw InputError(name + ": not a usable PNG: " + why); };
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    if (bytes.size() > 0x7FFFFFFF) fail("it is larger than 2 GiB");

    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) fail(stbi_failure_reason());
    if (static_cast<std::int64_t>(width) * height > most_pixels) fail("it has too many pixels");
    if (stbi_is_16_bit_from_memory(data, size) != 0) fail("its channels have 16 bits, expected 8");

    const int wanted = channels == 2 || channels == 4 ? 4 : 3;  // grey becomes RGB
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, wanted), &stbi_image_free);
    if (pixels == nullptr) fail(stbi_failure_reason());
    Image image(width, height, wanted);
    std::memcpy(image.bytes().data(), pixels.get(), image.bytes().size());
    return image;
}

}  // namespace sphereview

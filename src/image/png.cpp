#include "image/png.hpp"

#include <isa-l/crc.h>
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

// The four bytes at `at`, most significant first.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

// Whether every chunk up to the last (IEND) is there and has the sum that it says. stb_image looks at no sum.
bool chunks_are_whole(std::string_view bytes) {
    constexpr std::size_t signature = 8;
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    constexpr std::size_t frame = 12;  // a chunk's length, type and sum
    for (std::size_t at = signature; bytes.size() >= at + frame;) {
        const std::size_t length = number_at(bytes, at);
        if (bytes.size() - at - frame < length) return false;
        if (crc32_gzip_refl(0, data + at + 4, length + 4) != number_at(bytes, at + length + 8)) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += length + frame;
    }
    return false;
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

Image decode_png(std::string_view bytes, const std::string& name) {
    const auto fail = [&](const std::string& why) { throw InputError(name + ": not a usable PNG: " + why); };
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    if (bytes.size() > 0x7FFFFFFF) fail("it is larger than 2 GiB");

    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) fail(stbi_failure_reason());
    if (!chunks_are_whole(bytes)) fail("it is cut off or damaged");
    if (static_cast<std::int64_t>(width) * height > most_pixels) fail("it has too many pixels");
    if (stbi_is_16_bit_from_memory(data, size) != 0) fail("its channels have 16 bits, expected 8");

    const auto load = [&](int wanted) {
        std::unique_ptr<stbi_uc, void (*)(void*)> pixels(stbi_load_from_memory(data, size, &width, &height, &channels, wanted),
                                                         &stbi_image_free);
        if (pixels == nullptr) fail(stbi_failure_reason());
        return pixels;
    };
    // As it is first: that one colour is transparent (a tRNS chunk) is not known before.
    auto pixels = load(0);
    const int wanted = channels == 2 || channels == 4 ? 4 : 3;  // grey becomes RGB
    if (channels != wanted) pixels = load(wanted);
    Image image(width, height, wanted);
    std::memcpy(image.bytes().data(), pixels.get(), image.bytes().size());
    return image;
}

}  // namespace sphereview

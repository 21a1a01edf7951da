// The one place that compiles stb_image_write, with a compressor of our choice, and stb_image, for BMP files.
#include <libdeflate.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>

namespace {

// stb's hook: data -> a zlib stream from std::malloc, its size in *compressed_size; null when memory does not suffice.
// libdeflate packs the same data to the same bytes on every processor. ISA-L takes a tenth of the time, but what it writes depends
// on the processor and, rarely, on addresses. Level 2 takes half the time of level 1 for flat pictures, and packs better.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
    constexpr int level = 2;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(level), &libdeflate_free_compressor);
    if (compressor == nullptr) return nullptr;
    const auto length = static_cast<std::size_t>(size);
    const std::size_t room = libdeflate_zlib_compress_bound(compressor.get(), length);
    std::unique_ptr<void, decltype(&std::free)> out(std::malloc(room), &std::free);
    if (out == nullptr) return nullptr;
    const std::size_t packed = libdeflate_zlib_compress(compressor.get(), data, length, out.get(), room);
    if (packed == 0 || packed > std::numeric_limits<int>::max()) return nullptr;
    *compressed_size = static_cast<int>(packed);
    return static_cast<unsigned char*>(out.release());
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

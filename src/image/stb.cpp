// The one place that compiles the stb libraries, with libdeflate as the compressor of written PNGs.
#include <libdeflate.h>

#include <cstdlib>
#include <memory>

namespace {

// The fastest. Flat pictures are runs of one colour: higher levels gain a tenth for half as much time again.
constexpr int compression_level = 1;

// stb's hook: data -> a zlib stream from std::malloc, its size in *compressed_size; null when memory does not suffice.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(compression_level), &libdeflate_free_compressor);
    if (compressor == nullptr) return nullptr;
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), static_cast<std::size_t>(size));
    auto* out = static_cast<unsigned char*>(std::malloc(bound));
    if (out == nullptr) return nullptr;
    *compressed_size =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, static_cast<std::size_t>(size), out, bound));
    return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

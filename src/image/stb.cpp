// The one place that compiles the stb libraries, with compressors of our choice for written PNGs.
#include "image/stb.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace sphereview {

RowLayout& png_layout() {
    static thread_local RowLayout layout;
    return layout;
}

}  // namespace sphereview

namespace {

// The fastest, for pictures that are not flat: higher levels gain a tenth for half as much time again.
constexpr int compression_level = 1;

// stb's hook: data -> a zlib stream from std::malloc, its size in *compressed_size; null when memory does not suffice.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
    if (const auto runs = sphereview::run_deflate({data, static_cast<std::size_t>(size)}, sphereview::png_layout())) {
        auto* out = static_cast<unsigned char*>(std::malloc(runs->size()));
        if (out == nullptr) return nullptr;
        std::ranges::copy(*runs, out);
        *compressed_size = static_cast<int>(runs->size());
        return out;
    }
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

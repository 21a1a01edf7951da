#include "base/gzip_places.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <utility>

namespace sphereview {

std::string pack_window(const unsigned char* bytes, std::size_t count) {
    uLongf size = compressBound(static_cast<uLong>(count));
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes, static_cast<uLong>(count), Z_BEST_SPEED) != Z_OK) {
        throw std::bad_alloc();
    }
    packed.resize(size);
    packed.shrink_to_fit();
    return packed;
}

std::string unpack_window(const std::string& packed) {
    std::string bytes(gzip_window, '\0');
    uLongf size = gzip_window;
    const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
    bytes.resize(result == Z_OK ? size : 0);
    return bytes;
}

void GzipPlaces::add(GzipPlace place) {
    all_.push_back(std::move(place));
    if (all_.size() <= most) return;
    spacing_ *= 2;
    std::size_t kept = 0;
    for (std::size_t i = 1; i < all_.size(); i += 2) all_[kept++] = std::move(all_[i]);
    all_.resize(kept);
}

GzipPlace GzipPlaces::nearest(std::uint64_t unpacked) const {
    const auto behind = std::ranges::upper_bound(all_, unpacked, {}, &GzipPlace::unpacked);
    return behind == all_.begin() ? GzipPlace{} : *(behind - 1);
}

}  // namespace sphereview

#include <algorithm>

#include "base/error.hpp"
#include "fuzz/targets.hpp"
#include "image/png.hpp"

namespace sphereview {

namespace {

// A header may claim a picture of gigabytes, which is then allocated; that is allowed, but not what the fuzzer is for.
bool claims_too_much(std::string_view bytes) {
    constexpr std::uint64_t most = 1 << 20;
    if (bytes.size() < 24) return false;
    const auto number = [&](std::size_t offset) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
        return value;
    };
    return number(16) * number(20) > most;
}

}  // namespace

std::string fuzz_png(std::string_view bytes) {
    if (claims_too_much(bytes)) return "";
    Image image;
    try {
        image = decode_png(bytes, "picture.png");
    } catch (const InputError&) {
        return "";
    }
    const Image again = decode_png(encode_png(image), "again.png");
    const bool same = again.width() == image.width() && again.height() == image.height() && again.channels() == image.channels() &&
                      std::ranges::equal(again.bytes(), image.bytes());
    return same ? "" : "the picture is another one after writing and reading";
}

}  // namespace sphereview

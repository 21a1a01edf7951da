#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "base/error.hpp"
#include "fuzz/targets.hpp"
#include "image/compare.hpp"
#include "image/picture_file.hpp"
#include "image/png.hpp"
#include "support/temporary_folder.hpp"

namespace sphereview {

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

// A header may claim a picture of gigabytes, which is then allocated; that is allowed, but not what the fuzzer is for.
bool claims_too_much(const std::string& bytes) {
    constexpr std::uint64_t most = 1 << 20;
    return bytes.size() >= 24 && std::uint64_t{number_at(bytes, 16)} * number_at(bytes, 20) > most;
}

// Gives every chunk the sum that belongs to it: the fuzzer would never find one.
std::string with_sums(std::string bytes) {
    constexpr std::size_t signature = 8;
    constexpr std::size_t frame = 12;  // a chunk's length, type and sum
    for (std::size_t at = signature; bytes.size() >= at + frame;) {
        const std::size_t length = number_at(bytes, at);
        if (bytes.size() - at - frame < length) break;
        const auto* chunk = reinterpret_cast<const Bytef*>(bytes.data()) + at + 4;
        const auto sum = static_cast<std::uint32_t>(crc32(0, chunk, static_cast<uInt>(length + 4)));
        for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i));
        at += length + frame;
    }
    return bytes;
}

// What goes wrong when a picture of 3 x 2 pixels is compared with this golden; or "".
std::string wrong_with_comparison(const std::string& golden) {
    Image actual(3, 2, 4);
    std::ranges::fill(actual.bytes(), std::uint8_t{0x80});
    PngReader reader("golden.png", [rest = std::string_view(golden)](char* to, std::size_t most) mutable {
        const std::size_t count = rest.copy(to, most);
        rest.remove_prefix(count);
        return count;
    });
    Image difference;
    if (describe(compare(actual, reader, &difference)).empty()) return "a comparison without words";
    const bool holds_both =
        difference.width() == std::max(3, reader.width()) && difference.height() == std::max(2, reader.height());
    return holds_both ? "" : "a picture of the difference of another size";
}

// What goes wrong when the bytes are read, and what was read is written and read again; or "".
std::string wrong_with(const std::string& bytes) {
    Image image;
    try {
        image = decode_png(bytes, "picture.png");
    } catch (const InputError&) {
        return "";
    }
    const Image again = decode_png(encode_png(image), "again.png");
    const bool same = again.width() == image.width() && again.height() == image.height() && again.channels() == image.channels() &&
                      std::ranges::equal(again.bytes(), image.bytes());
    if (!same || !compare(again, image).equal()) return "the picture is another one after writing and reading";
    return wrong_with_comparison(bytes);
}

}  // namespace

std::string fuzz_picture(std::string_view bytes) {
    static const test::TemporaryFolder folder;
    try {
        const Image image = read_picture(folder.write("picture", bytes));
        if (image.width() < 1 || image.height() < 1) return "a picture without pixels";
    } catch (const InputError&) {
    } catch (const MemoryError&) {
    }
    return "";
}

std::string fuzz_png(std::string_view bytes) {
    const std::string file(bytes);
    if (claims_too_much(file)) return "";
    const std::string wrong = wrong_with(file);
    return wrong.empty() ? wrong_with(with_sums(file)) : wrong;
}

}  // namespace sphereview

#include "image/picture_file.hpp"

#include <stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "image/png.hpp"

namespace sphereview {

namespace {

// Throws where no picture of that size can be kept, or where the file, of `bytes`, is too short for one. `pixels_a_byte`: of the
// densest.
void check_size(const std::string& name, std::int64_t width, std::int64_t height, std::size_t bytes, std::size_t pixels_a_byte) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1 || width > most_pixels / height) {
        throw InputError(name + ": found a picture of " + size + " pixels, expected 1 to " + in_groups(most_pixels));
    }
    const auto pixels = static_cast<std::uint64_t>(width * height);
    if (pixels / pixels_a_byte > bytes) {
        throw InputError(name + ": found " + in_groups(bytes) + " bytes, expected more for a picture of " + size + " pixels");
    }
    require_memory(pixels * 8, name + ": a picture of " + size + " pixels needs");
}

// A PPM or PGM. Not by stb_image, which reads none that is text and takes what a cut off one lacks for black.
class PortableMap {
public:
    PortableMap(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Image read() {
        const bool grey = bytes_[1] == '2' || bytes_[1] == '5';
        const bool text = bytes_[1] == '2' || bytes_[1] == '3';
        const int width = next("the width", 1, std::numeric_limits<int>::max());
        const int height = next("the height", 1, std::numeric_limits<int>::max());
        check_size(name_, width, height, bytes_.size(), 1);
        const int most = next("the largest value", 1, text ? 65535 : 255);
        if (!text) ++at_;  // one white character
        Image image(width, height, 3);
        std::uint8_t* out = image.bytes().data();
        for (std::size_t i = 0; i < image.bytes().size(); i += 3) {
            for (std::size_t c = 0; c < 3; ++c) {
                out[i + c] = grey && c > 0 ? out[i] : scaled(text ? next("a value", 0, most) : next_byte(most), most);
            }
        }
        return image;
    }

private:
    static std::uint8_t scaled(int value, int most) { return static_cast<std::uint8_t>((value * 255 + most / 2) / most); }

    static bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw InputError(place_in(name_, position_at(bytes_, at_)) + "found " + found + ", expected " + expected);
    }

    int next(const std::string& what, int least, int most) {
        while (at_ < bytes_.size() && (is_white(bytes_[at_]) || bytes_[at_] == '#')) {
            if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
            ++at_;
        }
        const auto end = std::find_if(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end(), is_white);
        const std::string_view word = bytes_.substr(at_, static_cast<std::size_t>(end - bytes_.begin()) - at_);
        int value = 0;
        if (!parse_whole(word, value) || value < least || value > most) {
            fail(word.empty() ? "the end of the file" : in_quotes(word),
                 what + ", " + std::to_string(least) + " to " + std::to_string(most));
        }
        at_ += word.size();
        return value;
    }

    int next_byte(int most) {
        if (at_ >= bytes_.size()) throw InputError(name_ + ": found the end of the file, expected more pixels");
        const int value = static_cast<unsigned char>(bytes_[at_++]);
        return std::min(value, most);
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t at_ = 2;  // behind "P3"
};

// The number of so many bytes at an offset, the least first.
std::uint64_t number_at(std::string_view bytes, std::size_t offset, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return number;
}

// Bytes that a BMP of that size has: where the pixels begin, and rows of whole words. stb_image takes for black what is cut off.
std::uint64_t bytes_of_bmp(std::string_view bytes, std::int64_t width, std::int64_t height) {
    constexpr std::size_t offset_at = 10;
    const std::size_t bits_at = number_at(bytes, 14, 4) == 12 ? 24 : 28;
    const std::uint64_t bits = number_at(bytes, bits_at, 2);
    return number_at(bytes, offset_at, 4) +
           (static_cast<std::uint64_t>(width) * bits + 31) / 32 * 4 * static_cast<std::uint64_t>(height);
}

Image decode_bmp(std::string_view bytes, const std::string& name) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
    int width = 0;
    int height = 0;
    int channels = 0;
    const auto fail = [&] { throw InputError(name + ": not a usable BMP: " + on_one_line(stbi_failure_reason())); };
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) fail();
    const std::int64_t rows = std::abs(std::int64_t{height});  // negative: the top row first
    check_size(name, width, rows, bytes.size(), 8);
    constexpr std::size_t shortest_head = 30;
    if (bytes.size() < shortest_head) throw InputError(name + ": not a usable BMP: it is cut off");
    if (bytes_of_bmp(bytes, width, rows) > bytes.size()) {
        throw InputError(name + ": found " + in_groups(bytes.size()) + " bytes of a BMP, expected " +
                         in_groups(bytes_of_bmp(bytes, width, rows)));
    }
    const int wanted = channels == 4 ? 4 : 3;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, wanted), &stbi_image_free);
    if (pixels == nullptr && std::string_view(stbi_failure_reason()) == "outofmem") throw std::bad_alloc();
    if (pixels == nullptr) fail();
    Image image(width, height, wanted);
    std::memcpy(image.bytes().data(), pixels.get(), image.bytes().size());
    return image;
}

// What is no picture of those that are read.
std::string kind_in_words(std::string_view bytes) {
    if (bytes.empty()) return "an empty file";
    if (bytes.starts_with("\xFF\xD8\xFF")) return "a JPEG picture, whose colours are not exact";
    if (bytes.starts_with("GIF8")) return "a GIF picture";
    if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "a WebP picture";
    return "a file that begins with " + in_quotes(bytes.substr(0, 8));
}

using Decoder = Image (*)(std::string_view bytes, const std::string& name);

Image decode_map(std::string_view bytes, const std::string& name) { return PortableMap(bytes, name).read(); }

// By the first bytes.
Decoder decoder_of(std::string_view bytes, const std::string& name) {
    for (const char* map : {"P2", "P3", "P5", "P6"}) {
        if (bytes.starts_with(map)) return decode_map;
    }
    if (bytes.starts_with("BM")) return decode_bmp;
    if (bytes.starts_with("\x89PNG")) return decode_png;
    throw InputError(name + ": found " + kind_in_words(bytes) + ", expected a PNG, PPM, PGM or BMP picture");
}

}  // namespace

Image read_picture(const std::string& path) {
    constexpr std::size_t longest_mark = 12;
    InputStream stream(path, Content::binary);
    stream.fill(longest_mark);
    const Decoder decode = decoder_of(stream.bytes(), stream.name());  // before the rest, which may be large or have no end
    stream.fill();
    return decode(stream.bytes(), stream.name());
}

}  // namespace sphereview

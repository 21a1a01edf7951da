// PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace sphereview {

// The picture as an 8-bit RGB or RGBA PNG, of at most `most_pixels`. The same picture gives the same bytes
// on every processor; another release of the compressor may pack differently. Throws std::bad_alloc when memory does not suffice.
std::string encode_png(const Image& image);

// `path`, which may hold {name}, with ".png" added where the file's name has no ending. An ending is a letter and at most four more
// letters or digits behind the last dot. Devices, FIFOs, folders and "-" stay as they are. Throws InputError for another ending
// than .png, which would be wrong for the file, and for a dot at the end.
std::string png_name(const std::string& path);

// Pixels of one row: first_x, first_x + step and so on. Only an interlaced PNG has steps other than 1.
struct PngRow {
    int y;
    int first_x;
    int step;
    std::span<const std::uint8_t> bytes;  // the pixels, one after the other
};

// Reads a PNG of any kind as 8-bit RGB, or RGBA where it has transparency; 16-bit channels are refused rather than rounded. Only a
// row of it is ever in memory. Throws InputError for a file that is no PNG, is cut off or has a wrong sum anywhere, and
// std::bad_alloc.
class PngReader {
public:
    // Reads up to so many bytes of the file; 0 only at its end.
    using Source = std::function<std::size_t(char* to, std::size_t most)>;

    // Reads up to the first pixel. `name`: how messages call the file.
    PngReader(std::string name, Source source);
    PngReader(PngReader&&) noexcept;
    ~PngReader();

    const std::string& name() const;
    int width() const;
    int height() const;
    int channels() const;  // 3 or 4

    // Calls `take` for all rows, in the file's order: an interlaced PNG has seven rough pictures. Call once.
    void read(const std::function<void(const PngRow&)>& take);

private:
    struct Reading;
    std::unique_ptr<Reading> reading_;
};

// The PNG at `path`, or on standard input for "-". Throws InputError also when it cannot be read.
PngReader open_png(const std::string& path);

// The whole picture, of at most `most_pixels`. Throws as PngReader.
Image decode_png(std::string_view bytes, const std::string& name);

}  // namespace sphereview

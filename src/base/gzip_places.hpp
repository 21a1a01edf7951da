// Places from which a packed text can be unpacked without what stands before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sphereview {

// Deflate may refer to so many bytes before.
inline constexpr std::size_t gzip_window = std::size_t{1} << 15;

struct GzipPlace {
    std::uint64_t packed = 0;    // bytes of the file before it
    std::uint64_t unpacked = 0;  // bytes of the text before it
    unsigned bits = 0;           // number of high bits of the byte before it that belong to it: 0..7
    bool begins_member = true;   // refers to nothing before
    std::string text{};          // up to gzip_window bytes before it, packed by pack_window()

    bool operator==(const GzipPlace&) const = default;
};

std::string pack_window(const unsigned char* bytes, std::size_t count);
// "" for bytes that pack_window() has not made.
std::string unpack_window(const std::string& packed);

// Some places of a file, ascending; the longer the text, the farther apart, so that there are never many.
class GzipPlaces {
public:
    static constexpr std::size_t most = 512;
    static constexpr std::uint64_t usual_spacing = std::uint64_t{1} << 22;  // bytes of text

    explicit GzipPlaces(std::uint64_t spacing = usual_spacing) : spacing_(spacing) {}

    // Whether a place behind so many bytes of text is far enough from the last one.
    bool is_due(std::uint64_t unpacked) const { return unpacked >= (all_.empty() ? 0 : all_.back().unpacked) + spacing_; }
    void add(GzipPlace place);
    // The last place not behind `unpacked`, or the file's beginning.
    GzipPlace nearest(std::uint64_t unpacked) const;

    const std::vector<GzipPlace>& all() const { return all_; }
    std::uint64_t spacing() const { return spacing_; }

private:
    std::uint64_t spacing_;
    std::vector<GzipPlace> all_{};
};

}  // namespace sphereview

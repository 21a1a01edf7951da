// The header of a PLY.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "formats/lines.hpp"

namespace sphereview {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_whole(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
    std::string_view name{};
    PlyType type = PlyType::float32;      // of a list: its values'
    std::optional<PlyType> count_type{};  // of a list: its length's
};

// An element of the file: vertices, faces, or anything else.
struct PlyElement {
    std::string_view name{};
    std::size_t count = 0;  // as the file claims
    std::vector<PlyProperty> properties{};

    bool has_lists() const;
    // Bytes in a binary file, without the values of lists.
    std::size_t size() const;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    char line_end = '\n';
    std::vector<PlyElement> elements{};  // in the file's order
    std::size_t end = 0;                 // where the first element begins
};

// Reads the header at the beginning of the text. Throws InputError.
PlyHeader read_ply_header(const TextSource& source);

}  // namespace sphereview

// Compresses the rows of flat pictures: long runs of one colour, and rows that resemble the one above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sphereview {

// How the data of a PNG repeats itself, in bytes.
struct RowLayout {
    std::size_t pixel = 3;
    std::size_t row = 0;  // with the byte before it that names its filter
};

// A zlib stream (RFC 1950) of the data, the same bytes on every machine, or nothing where the data is not like that: a compressor
// that looks for all repetitions does better there. `layout.pixel` is 1 to 4.
std::optional<std::vector<std::uint8_t>> run_deflate(std::span<const std::uint8_t> data, const RowLayout& layout);

}  // namespace sphereview

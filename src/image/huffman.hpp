// Huffman codes as DEFLATE (RFC 1951) has them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sphereview {

// A code for each symbol: its bits, the first one lowest, and how many; 0 bits for a symbol that does not occur.
struct HuffmanCode {
    std::vector<std::uint16_t> bits;
    std::vector<std::uint8_t> lengths;
};

// The shortest code for symbols that occur so often, with no code longer than `longest` (at most 15) bits; the same everywhere. A
// code of a single symbol has one bit.
HuffmanCode huffman_code(std::span<const std::uint32_t> counts, int longest);

}  // namespace sphereview

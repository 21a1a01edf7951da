#include "image/run_deflate.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "image/huffman.hpp"

namespace sphereview {

namespace {

constexpr std::size_t shortest_match = 3;
constexpr std::size_t longest_match = 258;
constexpr std::size_t farthest_match = 32768;
constexpr std::size_t end_of_block = 256;
constexpr std::size_t length_symbols = 286;
constexpr std::size_t distance_symbols = 30;
// Where more of the bytes than this part repeat nothing, others compress better.
constexpr std::size_t bytes_per_literal = 24;
constexpr std::size_t literals_at_first = 512;

// The symbol of a length or distance, and the bits that follow it.
struct Coded {
    std::uint16_t symbol = 0;
    std::uint16_t extra = 0;
    std::uint8_t extra_bits = 0;
};

// Symbols stand for ranges that grow: `per_size` of 1 value each at first, then so many of 2, 4, ... values.
Coded in_ranges(std::size_t value, unsigned per_size_shift) {
    const auto width = static_cast<unsigned>(std::bit_width(value >> per_size_shift));
    const unsigned bits = width > 1 ? width - 1 : 0;
    return {static_cast<std::uint16_t>((bits << per_size_shift) + (value >> bits)),
            static_cast<std::uint16_t>(value & ((std::size_t{1} << bits) - 1)), static_cast<std::uint8_t>(bits)};
}

Coded coded_length(std::size_t length) {
    if (length == longest_match) return {285, 0, 0};
    Coded coded = in_ranges(length - shortest_match, 2);
    coded.symbol = static_cast<std::uint16_t>(coded.symbol + 257);
    return coded;
}

Coded coded_distance(std::size_t distance) { return in_ranges(distance - 1, 1); }

// A byte as it is, or a repetition of what is a pixel or a row before.
struct Token {
    enum class Kind : std::uint8_t { literal, pixel, row };
    std::uint16_t value;  // the byte, or how many
    Kind kind;
};

// How many bytes from `at` on equal those `distance` before them, up to `most`.
std::size_t run_length(const std::uint8_t* at, std::size_t distance, std::size_t most) {
    std::size_t length = 0;
    while (length + sizeof(std::uint64_t) <= most) {
        std::uint64_t here = 0;
        std::uint64_t before = 0;
        std::memcpy(&here, at + length, sizeof here);
        std::memcpy(&before, at + length - distance, sizeof before);
        if (here != before) break;
        length += sizeof here;
    }
    while (length < most && at[length] == at[length - distance]) ++length;
    return length;
}

std::optional<std::vector<Token>> tokens_of(std::span<const std::uint8_t> data, const RowLayout& layout) {
    std::vector<Token> tokens;
    std::size_t literals = 0;
    const bool with_rows = layout.row <= farthest_match && layout.row > 0;
    for (std::size_t at = 0; at < data.size();) {
        const std::size_t most = std::min(longest_match, data.size() - at);
        const std::size_t by_pixel = at >= layout.pixel ? run_length(&data[at], layout.pixel, most) : 0;
        const std::size_t by_row = with_rows && at >= layout.row && by_pixel < most ? run_length(&data[at], layout.row, most) : 0;
        const std::size_t length = std::max(by_pixel, by_row);
        if (length < shortest_match) {
            tokens.push_back({data[at], Token::Kind::literal});
            ++at;
            if (++literals > literals_at_first + at / bytes_per_literal) return std::nullopt;
            continue;
        }
        tokens.push_back({static_cast<std::uint16_t>(length), by_row > by_pixel ? Token::Kind::row : Token::Kind::pixel});
        at += length;
    }
    return tokens;
}

class BitWriter {
public:
    explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

    // The lowest first.
    void put(std::uint32_t bits, unsigned count) {
        held_ |= std::uint64_t{bits} << count_;
        count_ += count;
        while (count_ >= 8) {
            bytes_.push_back(static_cast<std::uint8_t>(held_));
            held_ >>= 8;
            count_ -= 8;
        }
    }
    void put(const HuffmanCode& code, std::size_t symbol) { put(code.bits[symbol], code.lengths[symbol]); }
    void put(const HuffmanCode& code, const Coded& coded) {
        put(code, coded.symbol);
        put(coded.extra, coded.extra_bits);
    }
    void finish() {
        if (count_ > 0) put(0, 8 - count_);
    }

private:
    std::vector<std::uint8_t>& bytes_;
    std::uint64_t held_ = 0;
    unsigned count_ = 0;
};

// The lengths of codes, as the header of a block has them: runs of zeros, and of one length, are symbols of their own.
std::vector<Coded> coded_lengths(const std::vector<std::uint8_t>& lengths) {
    std::vector<Coded> coded;
    for (std::size_t at = 0; at < lengths.size();) {
        const auto differs = [&](std::uint8_t length) { return length != lengths[at]; };
        const auto begin = lengths.begin() + static_cast<std::ptrdiff_t>(at);
        auto run = static_cast<std::size_t>(std::find_if(begin, lengths.end(), differs) - begin);
        if (lengths[at] == 0 && run >= 3) {
            run = std::min<std::size_t>(run, 138);
            const bool few = run <= 10;
            coded.push_back({static_cast<std::uint16_t>(few ? 17 : 18), static_cast<std::uint16_t>(run - (few ? 3 : 11)),
                             static_cast<std::uint8_t>(few ? 3 : 7)});
        } else if (run >= 4) {
            run = std::min<std::size_t>(run - 1, 6) + 1;
            coded.push_back({lengths[at], 0, 0});
            coded.push_back({16, static_cast<std::uint16_t>(run - 4), 2});
        } else {
            run = 1;
            coded.push_back({lengths[at], 0, 0});
        }
        at += run;
    }
    return coded;
}

template <std::size_t size>
std::size_t used(const std::array<std::uint32_t, size>& counts, std::size_t least) {
    std::size_t end = size;
    while (end > least && counts[end - 1] == 0) --end;
    return end;
}

void put_header(BitWriter& out, const HuffmanCode& lengths, std::size_t length_count, const HuffmanCode& distances,
                std::size_t distance_count) {
    constexpr std::array<std::size_t, 19> order = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    std::vector<std::uint8_t> all(lengths.lengths.begin(), lengths.lengths.begin() + static_cast<std::ptrdiff_t>(length_count));
    all.insert(all.end(), distances.lengths.begin(), distances.lengths.begin() + static_cast<std::ptrdiff_t>(distance_count));
    const std::vector<Coded> coded = coded_lengths(all);
    std::array<std::uint32_t, order.size()> counts{};
    for (const Coded& each : coded) ++counts[each.symbol];
    const HuffmanCode code = huffman_code(counts, 7);
    std::size_t end = order.size();
    while (end > 4 && code.lengths[order[end - 1]] == 0) --end;
    out.put(1, 1);  // the last block,
    out.put(2, 2);  // with codes of its own
    out.put(static_cast<std::uint32_t>(length_count - 257), 5);
    out.put(static_cast<std::uint32_t>(distance_count - 1), 5);
    out.put(static_cast<std::uint32_t>(end - 4), 4);
    for (std::size_t i = 0; i < end; ++i) out.put(code.lengths[order[i]], 3);
    for (const Coded& each : coded) out.put(code, each);
}

}  // namespace

std::optional<std::vector<std::uint8_t>> run_deflate(std::span<const std::uint8_t> data, const RowLayout& layout) {
    const auto tokens = tokens_of(data, layout);
    if (!tokens) return std::nullopt;
    const Coded by_pixel = coded_distance(layout.pixel);
    const Coded by_row = coded_distance(std::clamp<std::size_t>(layout.row, 1, farthest_match));
    std::array<std::uint32_t, length_symbols> length_counts{};
    std::array<std::uint32_t, distance_symbols> distance_counts{};
    for (const Token& token : *tokens) {
        if (token.kind == Token::Kind::literal) {
            ++length_counts[token.value];
        } else {
            ++length_counts[coded_length(token.value).symbol];
            ++distance_counts[(token.kind == Token::Kind::row ? by_row : by_pixel).symbol];
        }
    }
    length_counts[end_of_block] = 1;
    const HuffmanCode lengths = huffman_code(length_counts, 15);
    const HuffmanCode distances = huffman_code(distance_counts, 15);

    std::vector<std::uint8_t> bytes = {0x78, 0x01};  // windows of 32 KiB; quickly compressed
    BitWriter out(bytes);
    put_header(out, lengths, used(length_counts, 257), distances, used(distance_counts, 1));
    for (const Token& token : *tokens) {
        if (token.kind == Token::Kind::literal) {
            out.put(lengths, token.value);
        } else {
            out.put(lengths, coded_length(token.value));
            out.put(distances, token.kind == Token::Kind::row ? by_row : by_pixel);
        }
    }
    out.put(lengths, end_of_block);
    out.finish();
    const std::uint32_t sum = libdeflate_adler32(1, data.data(), data.size());
    for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
    return bytes;
}

}  // namespace sphereview

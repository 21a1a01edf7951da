#include "image/huffman.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace sphereview {

namespace {

constexpr int most_bits = 15;

struct Symbol {
    std::uint32_t count;
    std::uint16_t symbol;
};

// How deep each leaf of Huffman's tree lies, of symbols with ascending counts. Leaves and inner nodes are two queues that both
// ascend.
std::vector<int> depths_of(const std::vector<Symbol>& symbols) {
    const std::size_t leaves = symbols.size();
    std::vector<std::uint64_t> weights;
    weights.reserve(2 * leaves - 1);
    for (const Symbol& symbol : symbols) weights.push_back(symbol.count);
    std::vector<std::size_t> parents(2 * leaves - 1);
    std::size_t leaf = 0;
    std::size_t inner = leaves;
    const auto take_lightest = [&](std::size_t parent) {
        const bool is_leaf = leaf < leaves && (inner >= weights.size() || weights[leaf] <= weights[inner]);
        const std::size_t node = is_leaf ? leaf++ : inner++;
        parents[node] = parent;
        return weights[node];
    };
    while (weights.size() < parents.size()) {
        const std::size_t parent = weights.size();
        const std::uint64_t first = take_lightest(parent);
        weights.push_back(first + take_lightest(parent));
    }
    std::vector<int> depths(parents.size());
    for (std::size_t node = parents.size() - 1; node-- > 0;) depths[node] = depths[parents[node]] + 1;
    depths.resize(leaves);
    return depths;
}

// How many codes of each length, none longer than `longest`: what is too long moves up, and shorter ones make room for it.
std::array<int, most_bits + 1> lengths_within(const std::vector<int>& depths, int longest) {
    std::array<int, most_bits + 1> counts{};
    for (const int depth : depths) ++counts[static_cast<std::size_t>(std::min(depth, longest))];
    const auto limit = static_cast<std::size_t>(longest);
    std::int64_t used = 0;  // of 2^longest codes
    for (std::size_t length = 1; length <= limit; ++length) used += std::int64_t{counts[length]} << (limit - length);
    while (used > std::int64_t{1} << limit) {
        std::size_t length = limit - 1;
        while (counts[length] == 0) --length;
        // One of that length becomes two of the next, one of them for a code of the longest length.
        --counts[length];
        counts[length + 1] += 2;
        --counts[limit];
        --used;
    }
    return counts;
}

std::uint16_t reversed(std::uint32_t bits, int length) {
    std::uint32_t result = 0;
    for (int i = 0; i < length; ++i) result |= (bits >> i & 1U) << (length - 1 - i);
    return static_cast<std::uint16_t>(result);
}

}  // namespace

HuffmanCode huffman_code(std::span<const std::uint32_t> counts, int longest) {
    assert(longest >= 1 && longest <= most_bits && counts.size() <= std::size_t{1} << longest);
    HuffmanCode code{std::vector<std::uint16_t>(counts.size()), std::vector<std::uint8_t>(counts.size())};
    std::vector<Symbol> symbols;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) symbols.push_back({counts[i], static_cast<std::uint16_t>(i)});
    }
    if (symbols.empty()) return code;
    std::ranges::stable_sort(symbols, {}, &Symbol::count);
    if (symbols.size() == 1) {
        code.lengths[symbols[0].symbol] = 1;
    } else {
        const std::array<int, most_bits + 1> of_length = lengths_within(depths_of(symbols), longest);
        std::size_t next = 0;
        for (int length = longest; length >= 1; --length) {
            for (int n = of_length[static_cast<std::size_t>(length)]; n > 0; --n) {
                code.lengths[symbols[next++].symbol] = static_cast<std::uint8_t>(length);
            }
        }
    }
    // By length, then by symbol.
    std::uint32_t bits = 0;
    for (int length = 1; length <= longest; ++length) {
        bits <<= 1;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (code.lengths[i] == length) code.bits[i] = reversed(bits++, length);
        }
    }
    return code;
}

}  // namespace sphereview

// Counting at the speed of memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace sphereview {

// For how many i of [begin, end) `is(i)` holds. Where `is` looks at bytes alone and does not branch, compilers make SIMD of it:
// the sums of up to 255 places fit in a byte.
template <typename Is>
std::size_t count_places(std::size_t begin, std::size_t end, const Is& is) {
    constexpr std::size_t stride = 255;
    std::size_t count = 0;
    while (begin < end) {
        const std::size_t stop = begin + std::min(stride, end - begin);
        std::uint8_t sum = 0;
        for (; begin < stop; ++begin) sum = static_cast<std::uint8_t>(sum + static_cast<std::uint8_t>(is(begin)));
        count += sum;
    }
    return count;
}

}  // namespace sphereview

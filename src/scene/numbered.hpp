// Edits vectors with a value for each sphere when spheres are added, removed or reordered.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sphereview {

namespace detail {

template <typename Value>
auto place(std::vector<Value>& values, std::size_t number) {
    return values.begin() + static_cast<std::ptrdiff_t>(number);
}

}  // namespace detail

// Inserts unspecified values at these numbers, which ascend and count after the insertion.
template <typename Value>
void make_room(std::vector<Value>& values, std::span<const std::uint32_t> spheres) {
    std::size_t end = values.size();
    values.resize(end + spheres.size());
    // From the back: the old values that come after the i-th new one move up by i + 1 places.
    for (std::size_t i = spheres.size(); i-- > 0;) {
        const std::size_t begin = spheres[i] - i;
        std::copy_backward(detail::place(values, begin), detail::place(values, end), detail::place(values, end + i + 1));
        end = begin;
    }
}

// Removes the values of these spheres, which ascend; the others move up.
template <typename Value>
void take_out(std::vector<Value>& values, std::span<const std::uint32_t> spheres) {
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const std::size_t begin = std::size_t{spheres[i]} + 1;
        const std::size_t end = i + 1 < spheres.size() ? spheres[i + 1] : values.size();
        std::copy(detail::place(values, begin), detail::place(values, end), detail::place(values, begin - i - 1));
    }
    values.resize(values.size() - spheres.size());
}

// One sphere gets another number; those between move up or down by one.
template <typename Value>
void move_one(std::vector<Value>& values, std::size_t from, std::size_t to) {
    const auto first = detail::place(values, std::min(from, to));
    const auto last = detail::place(values, std::max(from, to) + 1);
    std::rotate(first, from < to ? first + 1 : last - 1, last);
}

}  // namespace sphereview

#include "exact/drawn_edits.hpp"

#include <algorithm>
#include <numeric>

namespace sphereview {

namespace {

void spell_out(std::vector<std::int32_t>& numbers, std::size_t count) {
    if (!numbers.empty()) return;
    numbers.reserve(count + DrawnSpheres::room_for_late);
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0);
}

// Gives each number of at least `first` another one; so many of the numbers are ascending.
template <typename Renumber>
void renumber(std::vector<std::int32_t>& numbers, std::size_t in_order, std::int32_t first, const Renumber& renumbered) {
    const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(in_order);
    for (auto number = std::lower_bound(numbers.begin(), end, first); number != numbers.end(); ++number) {
        *number = *number >= first ? renumbered(*number) : *number;
    }
}

template <typename Renumber>
void renumber(DrawnSpheres& drawn, std::int32_t first, const Renumber& renumbered) {
    spell_out(drawn.numbers, drawn.size());
    renumber(drawn.numbers, drawn.numbers.size() - drawn.late, first, renumbered);
    renumber(drawn.twins, drawn.twins.size(), first, renumbered);
}

bool is_one_run(std::span<const std::uint32_t> numbers) { return numbers.back() - numbers.front() + 1 == numbers.size(); }

}  // namespace

void renumber_for_came(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return;
    // At the end of a scene that is drawn as it is, nothing changes.
    if (drawn.numbers.empty() && numbers.front() >= drawn.size()) return;
    const auto first = static_cast<std::int32_t>(numbers.front());
    const auto count = static_cast<std::int32_t>(numbers.size());
    if (is_one_run(numbers)) {
        renumber(drawn, first, [=](std::int32_t number) { return number + count; });
        return;
    }
    // The i-th that came is before what was number numbers[i] - i.
    std::vector<std::int32_t> before;
    before.reserve(numbers.size());
    for (std::int32_t i = 0; i < count; ++i) before.push_back(static_cast<std::int32_t>(numbers[static_cast<std::size_t>(i)]) - i);
    renumber(drawn, first, [&](std::int32_t number) {
        return number + static_cast<std::int32_t>(std::ranges::upper_bound(before, number) - before.begin());
    });
}

void renumber_for_went(DrawnSpheres& drawn, std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return;
    std::erase_if(drawn.twins,
                  [&](std::int32_t number) { return std::ranges::binary_search(numbers, static_cast<std::uint32_t>(number)); });
    const auto first = static_cast<std::int32_t>(numbers.front());
    const auto count = static_cast<std::int32_t>(numbers.size());
    if (is_one_run(numbers)) {
        renumber(drawn, first, [=](std::int32_t number) { return std::max(number - count, first); });
        return;
    }
    renumber(drawn, first, [&](std::int32_t number) {
        const auto went = std::ranges::lower_bound(numbers, static_cast<std::uint32_t>(number)) - numbers.begin();
        return number - static_cast<std::int32_t>(went);
    });
}

void drop(DrawnSpheres& drawn, std::size_t index) {
    const auto gap = static_cast<std::uint32_t>(index);
    drawn.gone.insert(std::ranges::lower_bound(drawn.gone, gap), gap);
}

std::size_t append(DrawnSpheres& drawn, std::uint32_t number, const glm::vec4& center_radius) {
    const std::size_t index = drawn.size();
    if (!drawn.numbers.empty() || number != index) {
        spell_out(drawn.numbers, index);
        drawn.numbers.push_back(static_cast<std::int32_t>(number));
        ++drawn.late;
    }
    drawn.center_radius.push_back(center_radius);
    return index;
}

}  // namespace sphereview

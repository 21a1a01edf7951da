#include "scene/selection.hpp"

#include <algorithm>
#include <utility>

namespace sphereview {

bool Selection::contains(std::uint32_t number) const { return std::ranges::binary_search(numbers_, number); }

void Selection::clear() { *this = {}; }

void Selection::set(std::vector<std::uint32_t> numbers) {
    numbers_ = std::move(numbers);
    choose_last();
    std::ranges::sort(numbers_);
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
}

void Selection::set_only(std::uint32_t number) { set({number}); }

void Selection::toggle(std::uint32_t number) {
    const auto place = std::ranges::lower_bound(numbers_, number);
    if (place == numbers_.end() || *place != number) {
        numbers_.insert(place, number);
        primary_ = number;
    } else {
        numbers_.erase(place);
        if (primary_ == number) choose_last();
    }
}

void Selection::keep_below(std::size_t count) {
    numbers_.erase(std::ranges::lower_bound(numbers_, count), numbers_.end());
    if (primary_ && *primary_ >= count) choose_last();
}

void Selection::choose_last() { primary_ = numbers_.empty() ? std::nullopt : std::optional(numbers_.back()); }

}  // namespace sphereview

#include "edit/selection.hpp"

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <iterator>
#include <numeric>
#include <utility>

namespace sphereview {

namespace {

std::size_t place_of(const Color& color) {
    return (std::size_t{color.r} << 16U) + (std::size_t{color.g} << 8U) + std::size_t{color.b};
}

}  // namespace

bool Selection::contains(std::uint32_t number) const { return std::ranges::binary_search(numbers_, number); }

void Selection::clear() { *this = {}; }

void Selection::set(std::vector<std::uint32_t> numbers) {
    numbers_ = std::move(numbers);
    choose_last();
    if (!std::ranges::is_sorted(numbers_)) std::ranges::sort(numbers_);
    numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    changed();
}

void Selection::set_all(std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    set(std::move(all));
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
    changed();
}

void Selection::invert(std::size_t count) {
    std::vector<std::uint32_t> others;
    others.reserve(count - std::min(count, numbers_.size()));
    auto next = numbers_.begin();
    for (std::uint32_t number = 0; number < count; ++number) {
        if (next != numbers_.end() && *next == number) {
            ++next;
        } else {
            others.push_back(number);
        }
    }
    set(std::move(others));
}

void Selection::toggle_all(const std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> result;
    if (std::ranges::includes(numbers_, numbers)) {
        std::ranges::set_difference(numbers_, numbers, std::back_inserter(result));
    } else {
        std::ranges::set_union(numbers_, numbers, std::back_inserter(result));
    }
    set(std::move(result));
}

void Selection::keep_below(std::size_t count) {
    if (numbers_.empty() || numbers_.back() < count) return;
    numbers_.erase(std::ranges::lower_bound(numbers_, count), numbers_.end());
    if (*primary_ >= count) choose_last();
    changed();
}

void Selection::changed() {
    static std::atomic<std::uint64_t> latest = 0;
    version_ = numbers_.empty() ? 0 : ++latest;
}

void Selection::choose_last() { primary_ = numbers_.empty() ? std::nullopt : std::optional(numbers_.back()); }

double value_of(const Sphere& sphere, SphereValue value) {
    switch (value) {
        case SphereValue::radius: return sphere.radius;
        case SphereValue::red: return sphere.color.r;
        case SphereValue::green: return sphere.color.g;
        case SphereValue::blue: return sphere.color.b;
        default: return sphere.center[static_cast<int>(value)];
    }
}

void set_value(Sphere& sphere, SphereValue value, double number) {
    switch (value) {
        case SphereValue::radius: sphere.radius = number; break;
        case SphereValue::red: sphere.color.r = static_cast<std::uint8_t>(number); break;
        case SphereValue::green: sphere.color.g = static_cast<std::uint8_t>(number); break;
        case SphereValue::blue: sphere.color.b = static_cast<std::uint8_t>(number); break;
        default: sphere.center[static_cast<int>(value)] = number;
    }
}

SharedValues shared_values(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers) {
    SharedValues shared;
    shared.count = numbers.size();
    if (numbers.empty()) return shared;
    const Sphere& first = spheres[numbers.front()];
    shared.ranges.fill({DBL_MAX, -DBL_MAX});
    bool one_color = true;
    for (const std::uint32_t number : numbers) {
        const Sphere& sphere = spheres[number];
        for (std::size_t i = 0; i < shared.ranges.size(); ++i) {
            const double value = value_of(sphere, static_cast<SphereValue>(i));
            shared.ranges[i].low = std::min(shared.ranges[i].low, value);
            shared.ranges[i].high = std::max(shared.ranges[i].high, value);
        }
        one_color = one_color && sphere.color == first.color;
        if (sphere.hidden) ++shared.hidden;
    }
    if (one_color) shared.color = first.color;
    return shared;
}

std::vector<std::uint32_t> colored_like(const std::vector<Sphere>& spheres, const std::vector<std::uint32_t>& numbers) {
    std::vector<bool> wanted(std::size_t{1} << 24U);  // each colour there is
    for (const std::uint32_t number : numbers) wanted[place_of(spheres[number].color)] = true;
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (wanted[place_of(spheres[i].color)]) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

std::vector<std::uint32_t> hidden_ones(const std::vector<Sphere>& spheres) {
    std::vector<std::uint32_t> found;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (spheres[i].hidden) found.push_back(static_cast<std::uint32_t>(i));
    }
    return found;
}

}  // namespace sphereview

#include "panels/sphere_filter.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "base/text.hpp"

namespace sphereview {

namespace {

// The digits in "12", "#12", "sphere 12" and "re 12"; "" if the filter is none of those.
std::string_view digits_of(std::string_view filter) {
    const std::size_t begin = filter.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
    const std::string_view before = filter.substr(0, begin);
    return before == "#" || std::string_view("sphere ").ends_with(before) ? filter.substr(begin) : "";
}

}  // namespace

void FilterSearch::begin(const Scene& scene, std::string_view filter) {
    *this = {};
    filter_ = filter;
    wanted_ = lower_case(trimmed(filter));
    count_ = scene.spheres.size();
    unnamed_ = std::string_view("sphere").find(wanted_) != std::string_view::npos;  // what every one of them is called
    const std::string_view digits = digits_of(wanted_);
    std::uint64_t first = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), first);
    if (digits.empty() || fault != std::errc() || (digits.front() == '0' && digits.size() > 1)) return;
    for (std::uint64_t behind = first + 1; first < count_; first *= 10, behind *= 10) {
        numbers_.push_back({first, behind});
        if (first == 0) break;
    }
}

bool FilterSearch::fits(std::uint32_t number) const {
    return std::ranges::any_of(numbers_, [&](const NumberRange& range) { return range.first <= number && number < range.behind; });
}

bool FilterSearch::fits(std::string_view name) const {
    const auto same = [](char a, char b) { return ('A' <= a && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
    return std::search(name.begin(), name.end(), wanted_.begin(), wanted_.end(), same) != name.end() || wanted_.empty();
}

void FilterSearch::go_on(const Scene& scene, std::size_t step) {
    constexpr std::size_t for_a_name = 8;  // times as long as without
    std::size_t work = 0;
    auto name = scene.names.lower_bound(static_cast<std::uint32_t>(next_));
    while (next_ < count_ && work < for_a_name * step) {
        if (!unnamed_ && numbers_.empty()) next_ = name == scene.names.end() ? count_ : std::min<std::size_t>(name->first, count_);
        if (next_ == count_) return;
        const auto number = static_cast<std::uint32_t>(next_++);
        const bool named = name != scene.names.end() && name->first == number;
        if (fits(number) || (named ? fits(name->second) : unnamed_)) found_.push_back(number);
        work += named ? for_a_name : 1;
        if (named) ++name;
    }
}

void FilterSearch::finish(const Scene& scene) {
    while (!done()) go_on(scene);
}

std::optional<std::size_t> ListedSpheres::row_of(std::uint32_t number) const {
    if (all_) return number < count_ ? std::optional<std::size_t>(number) : std::nullopt;
    const auto found = std::ranges::lower_bound(listed_, number);
    if (found == listed_.end() || *found != number) return std::nullopt;
    return static_cast<std::size_t>(found - listed_.begin());
}

std::vector<std::uint32_t> ListedSpheres::between(std::size_t first, std::size_t last) const {
    if (first > last) std::swap(first, last);
    std::vector<std::uint32_t> numbers;
    numbers.reserve(last - first + 1);
    for (std::size_t row = first; row <= last; ++row) numbers.push_back((*this)[row]);
    return numbers;
}

}  // namespace sphereview

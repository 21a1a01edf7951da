#include "panels/sphere_filter.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "base/text.hpp"

namespace sphereview {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return "";
    return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

// The digits in "12", "#12", "sphere 12" and "re 12"; "" if the filter is none of those.
std::string_view digits_of(std::string_view filter) {
    const std::size_t begin = filter.find_last_not_of("0123456789") + 1;  // npos + 1 is 0
    const std::string_view before = filter.substr(0, begin);
    return before == "#" || std::string_view("sphere ").ends_with(before) ? filter.substr(begin) : "";
}

// All numbers below `count` whose decimal digits begin so.
void add_numbers(std::string_view digits, std::size_t count, std::vector<std::uint32_t>& found) {
    std::uint64_t first = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), first);
    if (fault != std::errc() || (digits.front() == '0' && digits.size() > 1)) return;
    std::uint64_t behind = first + 1;
    while (first < count) {
        for (std::uint64_t number = first; number < std::min<std::uint64_t>(behind, count); ++number) {
            found.push_back(static_cast<std::uint32_t>(number));
        }
        if (first == 0) return;
        first *= 10;
        behind *= 10;
    }
}

}  // namespace

std::vector<std::uint32_t> filtered(const Scene& scene, std::string_view filter) {
    const std::string wanted = lower_case(trimmed(filter));
    std::vector<std::uint32_t> found;
    const std::size_t count = scene.spheres.size();
    if (const std::string_view digits = digits_of(wanted); !digits.empty()) add_numbers(digits, count, found);
    if (std::string_view("sphere").find(wanted) != std::string_view::npos) {  // what every sphere without a name is called
        auto name = scene.names.begin();
        for (std::uint32_t number = 0; number < count; ++number) {
            while (name != scene.names.end() && name->first < number) ++name;
            if (name == scene.names.end() || name->first != number) found.push_back(number);
        }
    }
    for (const auto& [number, name] : scene.names) {
        if (lower_case(name).find(wanted) != std::string::npos) found.push_back(number);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
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

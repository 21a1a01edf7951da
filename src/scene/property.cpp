#include "scene/property.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

#include "base/number.hpp"

namespace sphereview {

namespace {

template <typename Number>
bool same_bytes(const std::vector<Number>& a, const std::vector<Number>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

bool same_bytes(const Labels& a, const Labels& b) { return a == b; }

template <typename Number>
std::size_t size_of_values(const std::vector<Number>& values) {
    return values.size();
}

std::size_t size_of_values(const Labels& labels) { return labels.numbers.size(); }

template <typename Number>
double number_in(const std::vector<Number>& values, std::size_t sphere) {
    return values[sphere];
}

double number_in(const std::vector<std::int32_t>& values, std::size_t sphere) {
    return values[sphere] == no_whole_number ? std::numeric_limits<double>::quiet_NaN() : values[sphere];
}

double number_in(const Labels&, std::size_t) { return std::numeric_limits<double>::quiet_NaN(); }

template <typename Number>
std::string text_in(const std::vector<Number>& values, std::size_t sphere) {
    return std::isnan(values[sphere]) ? "" : shortest(values[sphere]);
}

std::string text_in(const std::vector<std::int32_t>& values, std::size_t sphere) {
    return values[sphere] == no_whole_number ? "" : std::to_string(values[sphere]);
}

std::string text_in(const Labels& labels, std::size_t sphere) { return labels.words[labels.numbers[sphere]]; }

template <typename Number>
std::vector<Number>& one_for_each(std::vector<Number>& values) {
    return values;
}

std::vector<std::uint32_t>& one_for_each(Labels& labels) { return labels.numbers; }

bool has_value(double value) { return !std::isnan(value); }
bool has_value(float value) { return !std::isnan(value); }
bool has_value(std::int32_t value) { return value != no_whole_number; }

template <typename Number>
bool any_value(const std::vector<Number>& values) {
    return std::ranges::any_of(values, [](Number value) { return has_value(value); });
}

bool any_value(const Labels& labels) {
    return std::ranges::any_of(labels.numbers, [&](std::uint32_t number) { return !labels.words[number].empty(); });
}

template <typename Number>
std::vector<Number> chosen(const std::vector<Number>& values, std::span<const std::uint32_t> spheres) {
    std::vector<Number> some(spheres.size());
    std::ranges::transform(spheres, some.begin(), [&](std::uint32_t sphere) { return values[sphere]; });
    return some;
}

Labels chosen(const Labels& labels, std::span<const std::uint32_t> spheres) {
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> places(labels.words.size(), none);  // of each word in `some`
    Labels some{{}, chosen(labels.numbers, spheres)};
    for (std::uint32_t& number : some.numbers) {
        std::uint32_t& place = places[number];
        if (place == none) {
            place = static_cast<std::uint32_t>(some.words.size());
            some.words.push_back(labels.words[number]);
        }
        number = place;
    }
    return some;
}

// From the back: the old values that come after the i-th new one move up by i + 1 places.
template <typename Number>
void make_room(std::vector<Number>& values, std::span<const std::uint32_t> spheres) {
    std::size_t end = values.size();
    values.resize(end + spheres.size());
    for (std::size_t i = spheres.size(); i-- > 0;) {
        const std::size_t begin = spheres[i] - i;
        const auto first = values.begin();
        std::copy_backward(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                           first + static_cast<std::ptrdiff_t>(end + i + 1));
        end = begin;
    }
}

template <typename Number>
Number as_number(double value) {
    return static_cast<Number>(value);
}

template <>
std::int32_t as_number<std::int32_t>(double value) {
    const bool fits = value > no_whole_number && value <= std::numeric_limits<std::int32_t>::max();
    return fits ? static_cast<std::int32_t>(value) : no_whole_number;
}

template <typename Number>
void put_in(std::vector<Number>& values, std::span<const std::uint32_t> spheres, const Property* from) {
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const double value = from != nullptr ? number_at(*from, i) : std::numeric_limits<double>::quiet_NaN();
        values[spheres[i]] = as_number<Number>(value);
    }
}

void put_in(Labels& labels, std::span<const std::uint32_t> spheres, const Property* from) {
    std::map<std::string, std::uint32_t> numbers;  // of the words that are put in
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const auto [known, is_new] = numbers.try_emplace(from != nullptr ? text_at(*from, i) : "", 0U);
        if (is_new) {
            const auto place = std::ranges::find(labels.words, known->first);
            known->second = static_cast<std::uint32_t>(place - labels.words.begin());
            if (place == labels.words.end()) labels.words.push_back(known->first);
        }
        labels.numbers[spheres[i]] = known->second;
    }
}

}  // namespace

std::size_t size_of(const Property& property) {
    return std::visit([](const auto& values) { return size_of_values(values); }, property.values);
}

double number_at(const Property& property, std::size_t sphere) {
    return std::visit([sphere](const auto& values) { return number_in(values, sphere); }, property.values);
}

std::string text_at(const Property& property, std::size_t sphere) {
    return std::visit([sphere](const auto& values) { return text_in(values, sphere); }, property.values);
}

bool operator==(const Property& a, const Property& b) {
    if (a.name != b.name || a.values.index() != b.values.index()) return false;
    return std::visit([&b](const auto& values) { return same_bytes(values, std::get<std::decay_t<decltype(values)>>(b.values)); },
                      a.values);
}

bool has_values(const Property& property) {
    return std::visit([](const auto& values) { return any_value(values); }, property.values);
}

const Property* find_property(const std::vector<Property>& properties, std::string_view name) {
    const auto found = std::ranges::find(properties, name, &Property::name);
    return found == properties.end() ? nullptr : &*found;
}

std::size_t bytes_of(const Property& property) {
    constexpr std::size_t for_a_word = sizeof(std::string);
    const auto* const labels = std::get_if<Labels>(&property.values);
    const std::size_t words = labels != nullptr ? labels->words.size() : 0;
    const std::size_t for_a_value = std::holds_alternative<std::vector<double>>(property.values) ? sizeof(double) : sizeof(float);
    return sizeof(Property) + words * for_a_word + size_of(property) * for_a_value;
}

void reserve_values(Property& property, std::size_t spheres) {
    std::visit([spheres](auto& values) { one_for_each(values).reserve(spheres); }, property.values);
}

Property values_of(const Property& property, std::span<const std::uint32_t> spheres) {
    const auto choose = [&](const auto& values) -> decltype(property.values) { return chosen(values, spheres); };
    return {property.name, std::visit(choose, property.values)};
}

void remove_values(Property& property, std::span<const std::uint32_t> spheres) {
    const auto remove = [&](auto& values) {
        auto& all = one_for_each(values);
        const auto first = all.begin();
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const std::size_t begin = std::size_t{spheres[i]} + 1;
            const std::size_t end = i + 1 < spheres.size() ? spheres[i + 1] : all.size();
            std::copy(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                      first + static_cast<std::ptrdiff_t>(begin - i - 1));
        }
        all.resize(all.size() - spheres.size());
    };
    std::visit(remove, property.values);
}

void insert_values(Property& property, std::span<const std::uint32_t> spheres, const Property* from) {
    assert(from == nullptr || size_of(*from) == spheres.size());
    const auto insert = [&](auto& values) {
        make_room(one_for_each(values), spheres);
        put_in(values, spheres, from);
    };
    std::visit(insert, property.values);
}

void move_value(Property& property, std::size_t from, std::size_t to) {
    const auto move = [&](auto& values) {
        auto& all = one_for_each(values);
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(std::min(from, to));
        const auto last = all.begin() + static_cast<std::ptrdiff_t>(std::max(from, to) + 1);
        std::rotate(first, from < to ? first + 1 : last - 1, last);
    };
    std::visit(move, property.values);
}

}  // namespace sphereview

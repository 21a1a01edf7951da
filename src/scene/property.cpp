#include "scene/property.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <map>
#include <type_traits>

#include "base/number.hpp"
#include "scene/numbered.hpp"

namespace sphereview {

namespace {

template <typename Number>
bool same_bytes(const std::vector<Number>& a, const std::vector<Number>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

bool same_bytes(const Labels& a, const Labels& b) { return a == b; }

// The vector with a value for each sphere.
template <typename Values>
auto& one_for_each(Values& values) {
    if constexpr (std::is_same_v<std::remove_const_t<Values>, Labels>) {
        return values.numbers;
    } else {
        return values;
    }
}

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
bool has_value(const std::vector<Number>& values, std::size_t sphere) {
    return !std::isnan(number_in(values, sphere));
}

bool has_value(const Labels& labels, std::size_t sphere) { return !labels.words[labels.numbers[sphere]].empty(); }

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
    return std::visit([](const auto& values) { return one_for_each(values).size(); }, property.values);
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
    const auto has_any = [](const auto& values) {
        for (std::size_t i = 0; i < one_for_each(values).size(); ++i) {
            if (has_value(values, i)) return true;
        }
        return false;
    };
    return std::visit(has_any, property.values);
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
    using Values = decltype(Property::values);
    const auto choose = [&](const auto& values) { return Values(chosen(values, spheres)); };
    return {property.name, std::visit(choose, property.values)};
}

void remove_values(Property& property, std::span<const std::uint32_t> spheres) {
    std::visit([spheres](auto& values) { take_out(one_for_each(values), spheres); }, property.values);
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
    std::visit([from, to](auto& values) { move_one(one_for_each(values), from, to); }, property.values);
}

}  // namespace sphereview

// What a file holds of each sphere besides place, size and colour: a charge, a temperature, a chain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sphereview {

// Words, each kept once: elements, chains, types.
struct Labels {
    std::vector<std::string> words;      // in the order in which the file first has them; "" where a sphere has none
    std::vector<std::uint32_t> numbers;  // for each sphere, of a word

    bool operator==(const Labels&) const = default;
};

// What stands for no value among whole numbers.
inline constexpr std::int32_t no_whole_number = std::numeric_limits<std::int32_t>::min();

// One column of a file, at its own size: text as doubles or whole numbers, bytes as they are. Where a sphere has no value: NaN,
// no_whole_number or "".
struct Property {
    std::string name;  // as the file has it; not "", and no other of the scene has it
    std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>, Labels> values;
};

// For how many spheres it has a value.
std::size_t size_of(const Property& property);

inline bool is_category(const Property& property) { return std::holds_alternative<Labels>(property.values); }

// Of a sphere, below size_of(). NaN where it has none, and for a category.
double number_at(const Property& property, std::size_t sphere);

// Of a sphere, below size_of(), as people read it: the shortest number that reads back the same, or the word; "" where it has none.
std::string text_at(const Property& property, std::size_t sphere);

// Bit for bit, so that what has no value equals itself.
bool operator==(const Property& a, const Property& b);

// Whether any sphere has a value.
bool has_values(const Property& property);

// The one of that name, or null.
const Property* find_property(const std::vector<Property>& properties, std::string_view name);

// What it keeps in memory, about.
std::size_t bytes_of(const Property& property);

// Makes room for the values of so many spheres.
void reserve_values(Property& property, std::size_t spheres);

// The values of these spheres, each below size_of(), in that order. Of words only those that they have.
Property values_of(const Property& property, std::span<const std::uint32_t> spheres);

// Takes out the values of these spheres, which ascend; the others move up. Words stay, also those that nobody has any more.
void remove_values(Property& property, std::span<const std::uint32_t> spheres);

// Makes room for spheres that have these numbers, which ascend, afterwards, and puts in the values of `from`, one for each, as the
// kind that the property has; none where `from` is null. Words that are new come behind the others.
void insert_values(Property& property, std::span<const std::uint32_t> spheres, const Property* from);

// One sphere gets another number; those between move up or down by one.
void move_value(Property& property, std::size_t from, std::size_t to);

}  // namespace sphereview

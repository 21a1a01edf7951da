// Properties of spheres besides place, size and colour: a charge, a temperature, a chain.
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
    std::vector<std::string> words;      // in the order of the file; "" for spheres without a word
    std::vector<std::uint32_t> numbers;  // the place of each sphere's word

    bool operator==(const Labels&) const = default;
};

// A whole number that means no value.
inline constexpr std::int32_t no_whole_number = std::numeric_limits<std::int32_t>::min();

// One column of a file: doubles or whole numbers from text, binary types as they are. No value is NaN, no_whole_number or "".
struct Property {
    std::string name;  // as in the file; not "", and unique in the scene
    std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>, Labels> values;
};

// The number of spheres that the property has values for.
std::size_t size_of(const Property& property);

inline bool is_category(const Property& property) { return std::holds_alternative<Labels>(property.values); }

// A sphere's number; `sphere` is below size_of(). NaN for no value and for a category.
double number_at(const Property& property, std::size_t sphere);

// A sphere's value as text: the shortest number that reads back the same, or the word; "" for no value. `sphere` is below
// size_of().
std::string text_at(const Property& property, std::size_t sphere);

// Bit for bit, so that NaN equals NaN.
bool operator==(const Property& a, const Property& b);

// Whether any sphere has a value.
bool has_values(const Property& property);

// The property of that name, or null.
const Property* find_property(const std::vector<Property>& properties, std::string_view name);

// About how much memory the property takes.
std::size_t bytes_of(const Property& property);

// Reserves memory for the values of so many spheres.
void reserve_values(Property& property, std::size_t spheres);

// The values of these spheres, each below size_of(), in that order, with only their own words.
Property values_of(const Property& property, std::span<const std::uint32_t> spheres);

// Removes the values of these spheres, which ascend; the others move up. All words stay.
void remove_values(Property& property, std::span<const std::uint32_t> spheres);

// Inserts the values of `from`, converted to this property's kind, at these numbers, which ascend and count after the insertion; no
// values where `from` is null. New words come behind the others.
void insert_values(Property& property, std::span<const std::uint32_t> spheres, const Property* from);

// One sphere gets another number; those between move up or down by one.
void move_value(Property& property, std::size_t from, std::size_t to);

}  // namespace sphereview

// What a file holds of each sphere besides place, size and colour: a charge, a temperature, a chain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace sphereview {

// Words, each kept once: elements, chains, types.
struct Labels {
    std::vector<std::string> words;      // in the order in which the file first has them; "" where a sphere has none
    std::vector<std::uint32_t> numbers;  // for each sphere, of a word

    bool operator==(const Labels&) const = default;
};

// One column of a file, at its own size: text as doubles or whole numbers, bytes as they are. NaN where a sphere has no value.
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

}  // namespace sphereview

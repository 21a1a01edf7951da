// What the spheres of a scene can be coloured and sized by: the properties that it keeps, and its own numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Every scene has these, unless it keeps properties of the same names.
inline constexpr std::array<std::string_view, 4> own_value_names = {"x", "y", "z", "radius"};

// Of that name, in any letter case, those that are spelled the same first. Points into the scene, or to `own`, which is filled for
// one of own_value_names. Null where there is none.
const Property* find_values(const Scene& scene, std::string_view name, Property& own);

// How properties are called that say what element an atom is.
inline constexpr std::array<std::string_view, 5> element_property_names = {"element", "species", "symbol", "type_symbol", "atom"};
// Whether it is one of these, of words, and any of its words is an element.
bool holds_elements(const Property& values);
// The first that does; null where the scene keeps none.
const Property* find_elements(const Scene& scene);

// Numbers between which colours change. Finite and different; `low` may be above `high`, which turns the colours round.
struct ValueRange {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const ValueRange&) const = default;
};

// The least and the greatest of the finite numbers, of the spheres with these numbers or of all; those above 0 alone with `log`.
// Equal ones where there is only one number. Nothing where there is none.
std::optional<ValueRange> range_of(const Property& values, bool log, const std::vector<std::uint32_t>* spheres = nullptr);

// Where in the range a number is, 0 at `low` and 1 at `high`, and beyond for what is beyond; by the logarithm with `log`, for which
// the range is above 0. In the middle of a range of one number. NaN of NaN. The same double on every machine.
double part_of(double value, const ValueRange& range, bool log);
// The number at that part; of a logarithm's not the same on every machine.
double value_at(double part, const ValueRange& range, bool log);

// A number that a scale shows.
struct Tick {
    double part = 0.0;  // from 0 to 1
    std::string text;   // "0.25"
};

// Round numbers in the range, from low to high, at most so many of them (at least 2); its ends where no round ones lie in it.
std::vector<Tick> ticks_of(const ValueRange& range, bool log, int most);

// A number as people read it, with so many digits at most: "0.25", "1.5e-7".
std::string in_few_digits(double value, int digits);

}  // namespace sphereview

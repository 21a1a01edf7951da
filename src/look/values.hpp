// Values to colour and size spheres by: a scene's properties, and the spheres' own numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

// Values of every scene, unless it has properties of the same names.
inline constexpr std::array<std::string_view, 4> own_value_names = {"x", "y", "z", "radius"};

// The values of that name in any letter case; the same spelling first. Points into the scene, or to `own`, which is filled for
// own_value_names. Null for none.
const Property* find_values(const Scene& scene, std::string_view name, Property& own);

// Names of properties that hold atoms' elements.
inline constexpr std::array<std::string_view, 4> element_property_names = {"element", "species", "symbol", "type_symbol"};
// Whether a property has one of these names and words, any of which is an element.
bool holds_elements(const Property& values);
// The first such property of the scene, or null.
const Property* find_elements(const Scene& scene);

// The range over which colours change. Finite and different; `low` may be above `high`, which reverses the colours.
struct ValueRange {
    double low = 0.0;
    double high = 1.0;

    bool operator==(const ValueRange&) const = default;
};

// The least and the greatest finite number of all spheres, or of `spheres`; with `log` only of numbers above 0. Equal if there is a
// single number; nothing if there is none.
std::optional<ValueRange> range_of(const Property& values, bool log, const std::vector<std::uint32_t>* spheres = nullptr);

// The place of a number in the range, 0 at `low` and 1 at `high`, or beyond; by the logarithm with `log`, which needs a range above
// 0. 0.5 for a range of a single number; NaN for NaN. The same double on every machine.
double part_of(double value, const ValueRange& range, bool log);
// The number at that part. With `log` not the same on every machine.
double value_at(double part, const ValueRange& range, bool log);

// A number on a scale.
struct Tick {
    double part = 0.0;  // from 0 to 1
    std::string text;   // "0.25"
};

// Round numbers in the range, from low to high, at most `most` (which is at least 2); the range's ends if it has no round ones.
std::vector<Tick> ticks_of(const ValueRange& range, bool log, int most);

// A number for people, with at most `digits` digits: "0.25", "1.5e-7".
std::string in_few_digits(double value, int digits);

}  // namespace sphereview

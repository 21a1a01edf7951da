// Finds the property that a person means by a name.
#pragma once

#include <string_view>
#include <vector>

#include "scene/property.hpp"

namespace sphereview {

// How a typed name matches a property's: to the letter, in other letter case, or without the unit in brackets, "charge" for "Charge
// [e]".
enum class Likeness { none, without_unit, but_for_case, exact };
Likeness likeness(std::string_view typed, std::string_view name);

// The property whose name matches best, at least `least`; without its unit only if no other matches so. Null for none.
const Property* property_meant(const std::vector<Property>& properties, std::string_view typed, Likeness least);

}  // namespace sphereview

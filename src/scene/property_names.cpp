#include "scene/property_names.hpp"

#include "base/text.hpp"

namespace sphereview {

Likeness likeness(std::string_view typed, std::string_view name) {
    if (typed == name) return Likeness::exact;
    const std::string lower = lower_case(typed);
    if (lower == lower_case(name)) return Likeness::but_for_case;
    const std::size_t unit = name.find_first_of("([");
    const bool has_unit = unit != std::string_view::npos && (name.back() == ')' || name.back() == ']');
    const std::string_view bare = has_unit ? trimmed(name.substr(0, unit), " \t_") : std::string_view();
    return !bare.empty() && lower == lower_case(bare) ? Likeness::without_unit : Likeness::none;
}

const Property* property_meant(const std::vector<Property>& properties, std::string_view typed, Likeness least) {
    Likeness best = Likeness::none;
    const Property* meant = nullptr;
    for (const Property& property : properties) {
        const Likeness how = likeness(typed, property.name);
        if (how < least || how < best || how == Likeness::none) continue;
        // Of names that differ in letter case the first counts; of those with units neither.
        if (how > best) {
            meant = &property;
        } else if (how == Likeness::without_unit) {
            meant = nullptr;
        }
        best = how;
    }
    return meant;
}

}  // namespace sphereview

// The options that colour and size spheres by what their file holds.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "app/add_option.hpp"
#include "app/look.hpp"
#include "base/number.hpp"

namespace sphereview {

inline std::optional<ValueRange> parse_range(const std::string& text) {
    const std::size_t middle = text.find(':');
    if (middle == std::string::npos) return std::nullopt;
    ValueRange range;
    const bool good = parse_double(text.substr(0, middle), range.low) == NumberFault::none &&
                      parse_double(text.substr(middle + 1), range.high) == NumberFault::none && range.low != range.high;
    return good ? std::optional(range) : std::nullopt;
}

inline void add_look(CLI::App& command, LookOptions& look) {
    const auto property = [](const std::string& text) { return std::optional(text); };
    const std::string a_property = "the name of a property";
    CLI::Option* color_by = add_option(
        command, look.color_by,
        {"--color-by", "NAME",
         "Colour spheres by a property of their file, such as charge, chain or element; or by x, y, z or radius", a_property},
        property);
    const std::string maps = color_map_syntax();
    add_option(command, look.map, {"--colormap", "MAP", "Of numbers, with --color-by: " + maps + " [viridis]", maps},
               [](const std::string& text) { return color_map_named(text); })
        ->needs(color_by);
    const std::string a_range = "A:B, two different numbers";
    add_option(command, look.range,
               {"--range", "A:B",
                "From which number to which the colours go, either may be the larger [the least and the greatest]", a_range},
               parse_range)
        ->needs(color_by);
    add_flag(command, look.log, "--log", "Colours by the logarithm of the numbers")->needs(color_by);
    CLI::Option* size_by = add_option(
        command, look.size_by,
        {"--size-by", "NAME", "Radii by a property: --scale times the value; small where that is not above 0", a_property},
        property);
    add_option(command, look.scale,
               {"--scale", "S", "With --size-by: the radius of a value of 1 [by the distances of the spheres]", "a number above 0"},
               [](const std::string& text) { return number_above_0(text); })
        ->needs(size_by);
    const std::string kinds = listed(std::vector<std::string>(radii_names.begin(), radii_names.end()), "or");
    add_option(command, look.radii, {"--radii", "KIND", "Of atoms, by element: " + kinds, kinds}, [](const std::string& text) {
        return radii_named(text);
    })->excludes(size_by);
    add_option(command, look.radius_scale, {"--radius-scale", "F", "Every radius, times so much [1]", "a number above 0"},
               [](const std::string& text) { return number_above_0(text); });
}

inline void check_look(const LookOptions& look) {
    if (look.log && look.range && !(look.range->low > 0.0 && look.range->high > 0.0)) {
        wrong("--range", in_quotes(shortest(look.range->low) + ":" + shortest(look.range->high)), "numbers above 0 with --log");
    }
}

}  // namespace sphereview

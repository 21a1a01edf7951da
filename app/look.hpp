// What the command line says of colours and sizes, instead of the scene's file: by its properties, and by element.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/json.hpp"
#include "formats/sphere_data.hpp"
#include "look/coloring.hpp"
#include "look/sizes.hpp"
#include "scene/scene.hpp"

namespace sphereview {

struct LookOptions {
    std::optional<std::string> color_by;  // a property
    std::optional<ColorMap> map;          // these three with color_by
    std::optional<ValueRange> range;
    bool log = false;
    std::optional<ValueRange> range_of_frames;  // that another frame has given: of numbers, where `range` is none
    std::optional<CategoryOrder> order;         // that another frame has given
    std::optional<std::string> size_by;         // a property
    std::optional<double> scale;                // with size_by; > 0
    std::optional<RadiiKind> radii;             // not with size_by
    std::optional<double> radius_scale;         // > 0

    bool any() const { return color_by || size_by || radii || radius_scale; }
    bool operator==(const LookOptions&) const = default;
};

// How a file is to be read, with the properties that the look needs as well.
DataOptions with_properties(DataOptions data, const LookOptions& look);

// What became of them.
struct AppliedLook {
    std::optional<Coloring> coloring{};
    ColorBy colored_by{};
    bool has_values_beyond = false;           // the range that was asked for
    std::optional<ValueRange> found_range{};  // of the numbers, where none was asked for and they have one
    std::optional<Sizing> sizing{};
    std::optional<double> found_scale{};  // likewise
    std::string sized_by{};               // the property
    // What the spheres had before, where they have got others.
    std::vector<Color> own_colors{};
    std::vector<double> own_radii{};
    std::vector<std::string> lines{};  // of what was chosen, for people; each begins with the file's name
};

// {"color_by": {...}, "size_by": {...}}, each null where nothing was asked for.
Json to_json(const AppliedLook& look);

// Gives the scene, which the file `name` holds, these colours and radii. `has`: what the file holds of each sphere. Throws
// InputError where it has not what is asked for, with a list of what it has.
AppliedLook apply_look(Scene& scene, const LookOptions& options, const std::string& name, const std::vector<std::string>& has);

}  // namespace sphereview

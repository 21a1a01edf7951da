// The options for colours and sizes, which replace the file's: by property, and by element.
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
    std::optional<ColorMap> map;          // the next three need color_by
    std::optional<ValueRange> range;
    bool log = false;
    std::optional<ValueRange> range_of_frames;  // from another frame: of numbers, without `range`
    std::optional<CategoryOrder> order;         // from another frame
    std::optional<std::string> size_by;         // a property
    std::optional<double> scale;                // with size_by; > 0
    std::optional<RadiiKind> radii;             // not with size_by
    std::optional<double> radius_scale;         // > 0

    bool any() const { return color_by || size_by || radii || radius_scale; }
    bool operator==(const LookOptions&) const = default;
};

// `data` with the properties that the look needs as well.
DataOptions with_properties(DataOptions data, const LookOptions& look);

// The result of applying LookOptions.
struct AppliedLook {
    std::optional<Coloring> coloring{};
    ColorBy colored_by{};
    bool has_values_beyond = false;           // some value is beyond the wanted range
    std::optional<ValueRange> found_range{};  // of the numbers, if no range was asked for
    std::optional<Sizing> sizing{};
    std::optional<double> found_scale{};  // likewise
    std::string sized_by{};               // the property
    // The spheres' colours and radii before, where these were replaced.
    std::vector<Color> own_colors{};
    std::vector<double> own_radii{};
    std::vector<std::string> lines{};  // the choices, for people; each begins with the file's name
};

// {"color_by": {...}, "size_by": {...}}, each null where nothing was asked for.
Json to_json(const AppliedLook& look);

// Gives the scene of the file `name` these colours and radii. `has`: the file's properties. Throws InputError for a missing
// property, with a list of those.
AppliedLook apply_look(Scene& scene, const LookOptions& options, const std::string& name, const std::vector<std::string>& has);

}  // namespace sphereview

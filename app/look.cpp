#include "app/look.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::size_t most_names_listed = 30;

// "found no property 'q', expected one that the file has: charge and chain; or x, y, z or radius".
std::string missing(const std::string& asked, const std::vector<std::string>& has) {
    std::vector<std::string> candidates;
    for (const std::string_view own : own_value_names) {
        if (std::ranges::find(has, own) == has.end()) candidates.emplace_back(own);
    }
    const std::string of_all = listed(candidates, "or");
    candidates.insert(candidates.end(), has.begin(), has.end());
    const std::vector<std::string> shown = first_of(has, most_names_listed);
    return "found no property " + in_quotes(asked) + ", expected " +
           (shown.empty() ? of_all + ": the file has no others"
                          : "one that the file has, " + listed(shown, "or") + (of_all.empty() ? "" : ", or " + of_all)) +
           did_you_mean(asked, candidates);
}

const Property& values_for(const Scene& scene, const std::string& asked, const std::string& name,
                           const std::vector<std::string>& has, Property& own) {
    const Property* found = find_values(scene, asked, own);
    if (found == nullptr) throw InputError(name + ": " + missing(asked, has));
    return *found;
}

}  // namespace

Json to_json(const AppliedLook& look) {
    Json json = {{"color_by", nullptr}, {"size_by", nullptr}};
    if (look.sizing) {
        json.set("size_by", {{"property", look.sized_by}, {"scale", look.sizing->scale}, {"small", look.sizing->small}});
    }
    if (!look.coloring) return json;
    const Coloring& coloring = *look.coloring;
    Json color_by = {{"property", coloring.property}};
    if (coloring.is_category()) {
        Json categories = Json::array();
        for (const auto& [name, color, count] : coloring.categories) {
            categories.push_back({{"name", name}, {"color", rgb(color)}, {"count", count}});
        }
        color_by.set("categories", categories);
    } else {
        color_by.set("colormap", name_of(coloring.map));
        color_by.set("range", {coloring.range.low, coloring.range.high});
        color_by.set("log", coloring.log);
        color_by.set("without_value", coloring.without_value);
    }
    json.set("color_by", color_by);
    return json;
}

DataOptions with_properties(DataOptions data, const LookOptions& look) {
    std::vector<std::string>& names = data.properties;
    if (look.color_by) names.push_back(*look.color_by);
    if (look.size_by) names.push_back(*look.size_by);
    if (look.radii) names.insert(names.end(), element_property_names.begin(), element_property_names.end());
    return data;
}

AppliedLook apply_look(Scene& scene, const LookOptions& options, const std::string& name, const std::vector<std::string>& has) {
    AppliedLook applied;
    const std::string begin = name + ": ";
    // Both are looked for before anything changes.
    Property own_colors;
    Property own_sizes;
    const Property* colors = options.color_by ? &values_for(scene, *options.color_by, name, has, own_colors) : nullptr;
    const Property* sizes = options.size_by ? &values_for(scene, *options.size_by, name, has, own_sizes) : nullptr;
    if (colors != nullptr) {
        applied.colored_by = {colors->name, options.map, options.range, options.log, options.order};
        const bool by_category =
            is_category(*colors) || (!options.map && !options.range && !options.log && shown_by_category(*colors));
        if (!options.range && !by_category) applied.colored_by.range = options.range_of_frames;
        const std::optional<ValueRange>& range = applied.colored_by.range;
        try {
            applied.coloring = coloring_of(scene, *colors, applied.colored_by);
        } catch (const InputError& error) {
            throw InputError(begin + error.what());
        }
        const auto values = applied.coloring->is_category() ? std::nullopt : range_of(*colors, options.log);
        if (range) {
            const auto [least, greatest] = std::minmax(range->low, range->high);
            applied.has_values_beyond = values && (values->low < least || values->high > greatest);
        } else {
            applied.found_range = values;
        }
        for (const Sphere& sphere : scene.spheres) applied.own_colors.push_back(sphere.color);
        const std::vector<Color> found = colors_of(*colors, *applied.coloring);
        for (std::size_t i = 0; i < found.size(); ++i) scene.spheres[i].color = found[i];
        applied.lines.push_back(begin + in_words(*applied.coloring));
    }
    if (options.size_by || options.radii || options.radius_scale) {
        for (const Sphere& sphere : scene.spheres) applied.own_radii.push_back(sphere.radius);
    }
    if (sizes != nullptr) {
        if (is_category(*sizes)) {
            throw InputError(begin + sizes->name + ": found words, expected numbers, for sizes");
        }
        if (!options.scale) applied.found_scale = usual_scale(scene, *sizes);
        applied.sizing = size_by(scene.spheres, *sizes, options.scale.value_or(applied.found_scale.value_or(1.0)));
        applied.sized_by = sizes->name;
        const Sizing& sizing = *applied.sizing;
        applied.lines.push_back(
            begin + "radii by " + sizes->name + ": " + shortest(sizing.scale) + " times the value" +
            (sizing.small > 0 ? "; small: " + counted(sizing.small, "sphere") + " without a value above 0" : ""));
    }
    if (options.radii) {
        const Property* elements = find_elements(scene);
        if (elements == nullptr) throw InputError(begin + "found no elements, expected a file of atoms for --radii");
        const std::size_t kept = use_radii(scene.spheres, *elements, *options.radii);
        if (kept > 0) {
            applied.lines.push_back(begin + counted(kept, "sphere") + " without a known radius, " +
                                    std::string(radii_names[static_cast<std::size_t>(*options.radii)]) + ": as before");
        }
    }
    if (options.radius_scale) scale_radii(scene.spheres, *options.radius_scale);
    return applied;
}

}  // namespace sphereview

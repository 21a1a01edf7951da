// Colours by a property: a map for numbers, or a colour for each word.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "look/color_map.hpp"
#include "look/values.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// The categories that have the palette's first colours, in this order; of several frames the first one's. Any other category has a
// colour of the rest by its name alone, the same in every frame.
struct CategoryOrder {
    bool are_elements = false;         // the colours are the elements' usual ones
    std::vector<std::string> names{};  // without "", the category of spheres without a value

    bool operator==(const CategoryOrder&) const = default;
};

// A request for colours.
struct ColorBy {
    std::string property{};                // in any letter case
    std::optional<ColorMap> map{};         // for numbers; none: viridis
    std::optional<ValueRange> range{};     // none: from the least to the greatest
    bool log = false;                      // by the logarithm of the numbers
    std::optional<CategoryOrder> order{};  // for categories; none: the scene's own

    bool operator==(const ColorBy&) const = default;
};

struct Category {
    std::string name;  // "": spheres without a value
    Color color;
    std::size_t count = 0;  // of its shown spheres

    bool operator==(const Category&) const = default;
};

// How values become colours, as a legend shows it.
struct Coloring {
    std::string property{};
    // For numbers: a map and a range.
    ColorMap map = ColorMap::viridis;
    ValueRange range{};
    bool log = false;
    // For words, else empty; in a legend's order: elements by Hill (C, H, then by the alphabet), other words by the alphabet,
    // numbers by size; at last the one without a name.
    std::vector<Category> categories{};
    CategoryOrder order{};          // gives these their colours
    std::size_t without_value = 0;  // for numbers: number of shown spheres without one

    bool is_category() const { return !categories.empty(); }
    bool operator==(const Coloring&) const = default;
};

// Whether a property is shown by category: words, and whole numbers with a name such as "type".
bool shown_by_category(const Property& values);

// Throws InputError, which begins with "NAME: ", for values that do not suit `by`: a range for words, a logarithm of numbers none
// of which is above 0. Elements get their usual colours.
Coloring coloring_of(const Scene& scene, const Property& values, const ColorBy& by);

// A colour for every sphere.
std::vector<Color> colors_of(const Property& values, const Coloring& coloring);

// The part of the spheres with these colours, 0 to 1; of many spheres a sample is tested.
double part_with_colors(const Scene& scene, const Property& values, const Coloring& coloring);

// "colours by charge: viridis from -0.8 to 0.4", "colours by chain: 3 categories": for people.
std::string in_words(const Coloring& coloring);

}  // namespace sphereview

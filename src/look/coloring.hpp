// Colours by what a file holds of each sphere: a map of numbers, or one colour for each word.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "look/color_map.hpp"
#include "look/values.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// Which categories have the palette's first colours, in this order: of several frames those of the first one. Any other category
// has a colour of the rest by its name alone, the same in every frame.
struct CategoryOrder {
    bool are_elements = false;         // with the usual colours of these, instead of the palette's
    std::vector<std::string> names{};  // without that of spheres that have none

    bool operator==(const CategoryOrder&) const = default;
};

// What is asked for.
struct ColorBy {
    std::string property{};                // by its name, in any letter case
    std::optional<ColorMap> map{};         // of numbers; none: viridis
    std::optional<ValueRange> range{};     // none: from the least to the greatest
    bool log = false;                      // by the logarithm of the numbers
    std::optional<CategoryOrder> order{};  // of categories; none: the scene's own

    bool operator==(const ColorBy&) const = default;
};

// Of a category.
struct Category {
    std::string name;  // "" of the spheres that have none
    Color color;
    std::size_t count = 0;  // of the spheres with it that are not hidden

    bool operator==(const Category&) const = default;
};

// How values become colours: what a legend shows.
struct Coloring {
    std::string property{};
    // Of numbers: a map and a range.
    ColorMap map = ColorMap::viridis;
    ValueRange range{};
    bool log = false;
    // Of words: not empty, in the order in which people look for them: elements by Hill (C, H, then by the alphabet), others by the
    // alphabet, numbers by size; at last the one without a name.
    std::vector<Category> categories{};
    CategoryOrder order{};          // by which these have their colours
    std::size_t without_value = 0;  // of numbers: how many spheres that are not hidden have none

    bool is_category() const { return !categories.empty(); }
    bool operator==(const Coloring&) const = default;
};

// Whether a property is shown by category: words, and whole numbers that are called a type.
bool shown_by_category(const Property& values);

// Throws InputError, which begins with "NAME: ", where the values are not such as `by` asks for: a range for words, a logarithm of
// numbers none of which is above 0. Elements keep the colours that every program gives them.
Coloring coloring_of(const Scene& scene, const Property& values, const ColorBy& by);

// A colour for every sphere.
std::vector<Color> colors_of(const Property& values, const Coloring& coloring);

// Which part of the spheres have these colours, from 0 to 1: looked at for some of them, where there are many.
double part_with_colors(const Scene& scene, const Property& values, const Coloring& coloring);

// "colours by charge: viridis from -0.8 to 0.4", "colours by chain: 3 categories": for people.
std::string in_words(const Coloring& coloring);

}  // namespace sphereview

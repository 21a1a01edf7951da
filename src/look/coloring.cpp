#include "look/coloring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

// By what words that are elements, and others, are grouped and ordered.
std::string group_of(const std::string& word, bool elements) {
    if (!elements || word.empty()) return word;
    const Element& element = element_of_species(word);
    return element.symbol.empty() ? word : std::string(element.symbol);
}

// Elements by Hill, numbers by size, others by their letters.
auto order_of(const std::string& word, bool elements) {
    double number = 0.0;
    const bool is_number = parse_double(word, number) == NumberFault::none;
    const int hill = !elements ? 0 : word == "C" ? 0 : word == "H" ? 1 : 2;
    return std::tuple(word.empty(), hill, !is_number, is_number ? number : 0.0, word);
}

std::string word_of(const Property& values, std::size_t sphere) {
    const double number = number_at(values, sphere);
    return std::isnan(number) ? text_at(values, sphere) : shortest(number);
}

// The colours of a category's words, or of its numbers.
class CategoryColors {
public:
    CategoryColors(const Property& values, const Coloring& coloring) : values_(values), elements_(coloring.order.are_elements) {
        for (const Category& category : coloring.categories) by_name_.emplace(category.name, category.color);
        if (const auto* labels = std::get_if<Labels>(&values.values)) {
            for (const std::string& word : labels->words) of_words_.push_back(find(group_of(word, elements_)));
        }
    }

    Color operator()(std::size_t sphere) const {
        if (const auto* labels = std::get_if<Labels>(&values_.values)) return of_words_[labels->numbers[sphere]];
        return find(word_of(values_, sphere));
    }

private:
    Color find(const std::string& name) const {
        const auto found = by_name_.find(name);
        return found == by_name_.end() ? no_value_color : found->second;
    }

    const Property& values_;
    bool elements_;
    std::map<std::string, Color> by_name_;
    std::vector<Color> of_words_;
};

Color color_of_number(double value, const Coloring& coloring) {
    const double part = part_of(value, coloring.range, coloring.log);
    return std::isnan(part) ? no_value_color : color_of(coloring.map, part);
}

// One that the first frame has not gets one of the colours that are left, the next whole number the next one.
Color color_of_later(const std::string& name, std::size_t of_first) {
    const std::size_t before = of_first < category_colors ? of_first : 0;
    const std::size_t left = category_colors - before;
    double number = 0.0;
    if (parse_double(name, number) == NumberFault::none && number == std::floor(number) && std::abs(number) < 1e15) {
        const auto count = static_cast<std::int64_t>(left);
        const std::int64_t place = (static_cast<std::int64_t>(number) - 1 - static_cast<std::int64_t>(before)) % count;
        return category_color(before + static_cast<std::size_t>(place < 0 ? place + count : place));
    }
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
    return category_color(before + static_cast<std::size_t>(hash % left));
}

std::vector<Category> categories_of(const Scene& scene, const Property& values, bool elements) {
    std::map<std::string, std::size_t> counts;  // also of those that only hidden spheres have
    if (const auto* labels = std::get_if<Labels>(&values.values)) {
        std::vector<std::size_t> of_words(labels->words.size());
        std::vector<bool> used(labels->words.size());
        for (std::size_t i = 0; i < labels->numbers.size(); ++i) {
            used[labels->numbers[i]] = true;
            of_words[labels->numbers[i]] += scene.spheres[i].hidden ? 0 : 1;
        }
        for (std::size_t i = 0; i < of_words.size(); ++i) {
            if (used[i]) counts[group_of(labels->words[i], elements)] += of_words[i];
        }
    } else {
        for (std::size_t i = 0; i < size_of(values); ++i) counts[word_of(values, i)] += scene.spheres[i].hidden ? 0 : 1;
    }
    std::vector<Category> categories;
    for (const auto& [name, count] : counts) categories.push_back({name, no_value_color, count});
    std::ranges::sort(categories, {}, [&](const Category& category) { return order_of(category.name, elements); });
    return categories;
}

void color_categories(std::vector<Category>& categories, const CategoryOrder& order) {
    std::unordered_map<std::string_view, std::size_t> places;
    for (const std::string& name : order.names) places.emplace(name, places.size());
    for (Category& category : categories) {
        if (category.name.empty()) continue;
        const auto place = places.find(category.name);
        category.color = order.are_elements      ? element_of_species(category.name).color
                         : place != places.end() ? category_color(place->second)
                                                 : color_of_later(category.name, places.size());
    }
}

// Whole numbers, few enough to be kinds of something.
bool are_kinds(const Property& values) {
    constexpr std::size_t most_kinds = 1000;
    std::map<double, bool> kinds;
    for (std::size_t i = 0; i < size_of(values); ++i) {
        const double value = number_at(values, i);
        if (std::isnan(value)) continue;
        if (value != std::floor(value) || kinds.size() > most_kinds) return false;
        kinds[value] = true;
    }
    return true;
}

}  // namespace

bool shown_by_category(const Property& values) {
    if (is_category(values)) return true;
    constexpr std::array<std::string_view, 4> kinds = {"type", "atom_type", "atom type", "particle type"};
    return std::ranges::find(kinds, lower_case(values.name)) != kinds.end() && are_kinds(values);
}

Coloring coloring_of(const Scene& scene, const Property& values, const ColorBy& by) {
    const std::string name = on_one_line(values.name) + ": ";
    Coloring coloring;
    coloring.property = values.name;
    const bool as_numbers = by.map || by.range || by.log;
    if (is_category(values) && (by.range || by.log)) {
        throw InputError(name + "found words, expected numbers for a range or a logarithm");
    }
    if (is_category(values) || (!as_numbers && shown_by_category(values))) {
        CategoryOrder& order = coloring.order;
        order = by.order.value_or(CategoryOrder{holds_elements(values)});
        coloring.categories = categories_of(scene, values, order.are_elements);
        for (const Category& category : coloring.categories) {
            if (!by.order && !order.are_elements && !category.name.empty()) order.names.push_back(category.name);
        }
        color_categories(coloring.categories, order);
        return coloring;
    }
    coloring.map = by.map.value_or(ColorMap::viridis);
    coloring.log = by.log;
    const std::optional<ValueRange> found = range_of(values, by.log);
    if (by.log && !found && !by.range) throw InputError(name + "found no number above 0, expected one for a logarithm");
    coloring.range = by.range ? *by.range : found.value_or(ValueRange{0.0, 0.0});
    if (by.log && !(coloring.range.low > 0.0 && coloring.range.high > 0.0)) {
        throw InputError(name + "found a range that is not above 0, expected one above 0 for a logarithm");
    }
    for (std::size_t i = 0; i < size_of(values); ++i) {
        coloring.without_value += std::isnan(number_at(values, i)) && !scene.spheres[i].hidden ? 1 : 0;
    }
    return coloring;
}

std::vector<Color> colors_of(const Property& values, const Coloring& coloring) {
    std::vector<Color> colors(size_of(values));
    if (coloring.is_category()) {
        const CategoryColors color(values, coloring);
        for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = color(i);
        return colors;
    }
    for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = color_of_number(number_at(values, i), coloring);
    return colors;
}

double part_with_colors(const Scene& scene, const Property& values, const Coloring& coloring) {
    if (scene.spheres.empty() || size_of(values) != scene.spheres.size()) return 0.0;
    constexpr std::size_t most_looked_at = 1000;
    const std::size_t step = scene.spheres.size() / most_looked_at + 1;
    const std::optional<CategoryColors> of_category =
        coloring.is_category() ? std::optional<CategoryColors>(std::in_place, values, coloring) : std::nullopt;
    std::size_t looked_at = 0;
    std::size_t same = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); i += step) {
        const Color color = of_category ? (*of_category)(i) : color_of_number(number_at(values, i), coloring);
        ++looked_at;
        same += scene.spheres[i].color == color ? 1 : 0;
    }
    return static_cast<double>(same) / static_cast<double>(looked_at);
}

std::string in_words(const Coloring& coloring) {
    const std::string by = "colours by " + on_one_line(coloring.property) + ": ";
    const auto has = [](std::size_t count) { return in_groups(count) + (count == 1 ? " sphere has" : " spheres have"); };
    if (coloring.is_category()) {
        const auto named = std::ranges::count_if(coloring.categories, [](const Category& one) { return !one.name.empty(); });
        return by + in_groups(static_cast<std::uint64_t>(named)) + (named == 1 ? " category" : " categories");
    }
    return by + std::string(name_of(coloring.map)) + " from " + shortest(coloring.range.low) + " to " +
           shortest(coloring.range.high) + (coloring.log ? ", by the logarithm" : "") +
           (coloring.without_value > 0
                ? "; " + has(coloring.without_value) + " no value, and " + (coloring.without_value == 1 ? "is grey" : "are grey")
                : "");
}

}  // namespace sphereview

#include "formats/property_columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/square_root.hpp"
#include "base/text.hpp"
#include "formats/csv_values.hpp"
#include "formats/elements.hpp"
#include "scene/property_names.hpp"

namespace sphereview {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// NaN for what is no finite number; 2+ and 1- are charges.
double value_in(std::string_view text, Commas commas) {
    double value = 0.0;
    if (parse_double(text, value) == NumberFault::none) return value;
    if (parse_csv_number(text, commas, value) == NumberFault::none) return value;
    if (text.size() > 1 && (text.back() == '+' || text.back() == '-') &&
        parse_double(text.substr(0, text.size() - 1), value) == NumberFault::none) {
        return text.back() == '-' ? -value : value;
    }
    return no_number;
}

}  // namespace

std::string element_in_words(std::string_view species) {
    const std::string_view symbol = element_of_species(species).symbol;
    return symbol.empty() ? as_utf8(species) : std::string(symbol);
}

void add_column(std::vector<PropertyColumn>& columns, std::string_view name, PropertyKind kind, std::size_t place) {
    if (name.empty() || columns.size() >= most_property_columns) return;
    const std::string text = as_utf8(name);
    std::string unique = text;
    for (int i = 2; std::ranges::find(columns, unique, &PropertyColumn::name) != columns.end(); ++i) {
        unique = text + " " + std::to_string(i);
    }
    columns.push_back({std::move(unique), kind, place});
}

bool is_wanted(const DataOptions& options, std::string_view name, std::size_t spheres) {
    if (options.all_properties || (spheres > 0 && spheres <= options.all_properties_up_to)) return true;
    const auto is_it = [&](const std::string& wanted) { return likeness(wanted, name) != Likeness::none; };
    return std::ranges::any_of(options.properties, is_it);
}

bool set_number(Property& property, std::size_t sphere, double value) {
    const bool is_whole = value == std::floor(value);
    if (auto* const doubles = std::get_if<std::vector<double>>(&property.values)) {
        (*doubles)[sphere] = std::isfinite(value) ? value : no_number;
        return !std::isinf(value);
    }
    if (auto* const floats = std::get_if<std::vector<float>>(&property.values)) {
        const auto number = static_cast<float>(value);
        (*floats)[sphere] = std::isfinite(number) ? number : static_cast<float>(no_number);
        return !std::isinf(number);
    }
    if (auto* const wholes = std::get_if<std::vector<std::int32_t>>(&property.values)) {
        const bool fits = is_whole && value > no_whole_number && value <= std::numeric_limits<std::int32_t>::max();
        (*wholes)[sphere] = fits ? static_cast<std::int32_t>(value) : no_whole_number;
        return fits || std::isnan(value);
    }
    Labels& labels = std::get<Labels>(property.values);
    const bool fits = is_whole && value >= 0.0 && value < static_cast<double>(labels.words.size());
    if (fits) labels.numbers[sphere] = static_cast<std::uint32_t>(value);
    return fits;
}

PropertyValues::PropertyValues(const PropertyColumn& column, std::size_t count)
    : column_(column),
      count_(count),
      is_whole_(column.kind == PropertyKind::found || column.kind == PropertyKind::whole),
      is_words_(column.kind == PropertyKind::words || column.kind == PropertyKind::element) {
    if (is_words_) {
        labels_.numbers.reserve(count);
    } else if (is_whole_) {
        wholes_.reserve(count);
    } else {
        numbers_.reserve(count);
    }
}

void PropertyValues::begin_again() {
    wholes_ = {};
    numbers_ = {};
    is_whole_ = false;
    is_words_ = true;
    labels_.numbers.reserve(count_);
}

void PropertyValues::add(std::string_view text, Commas commas) {
    if (is_words_) {
        add_word(text);
    } else if (!needs_words_) {
        add_number(text, commas);
    }
}

void PropertyValues::add_number(std::string_view text, Commas commas) {
    if (is_whole_) {
        std::int32_t whole = no_whole_number;
        const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
        if (parse_whole(plus ? text.substr(1) : text, whole) && whole != no_whole_number) {
            wholes_.push_back(whole);
            return;
        }
        if (is_missing(text)) {
            wholes_.push_back(no_whole_number);
            return;
        }
        const auto as_double = [](std::int32_t value) { return value == no_whole_number ? no_number : value; };
        is_whole_ = false;
        numbers_.reserve(count_);
        std::ranges::transform(wholes_, std::back_inserter(numbers_), as_double);
        wholes_ = {};
    }
    const double value = value_in(text, commas);
    if (std::isnan(value) && column_.kind == PropertyKind::found && !is_missing(text)) {
        needs_words_ = true;
        numbers_ = {};
        return;
    }
    numbers_.push_back(value);
}

void PropertyValues::add_word(std::string_view text) {
    if (!labels_.numbers.empty() && text == last_word_) {
        labels_.numbers.push_back(last_number_);
        return;
    }
    if (has_too_many_words()) return;
    last_word_.assign(text);
    auto known = word_numbers_.find(text);
    if (known == word_numbers_.end()) {
        // Several spellings may be one word, which itself stays as it is.
        std::string word = column_.kind == PropertyKind::element ? element_in_words(text) : as_utf8(text);
        const auto [same, is_new] = word_numbers_.try_emplace(word, static_cast<std::uint32_t>(labels_.words.size()));
        if (is_new) labels_.words.push_back(std::move(word));
        known = word_numbers_.try_emplace(last_word_, same->second).first;
    }
    last_number_ = known->second;
    labels_.numbers.push_back(last_number_);
}

Property PropertyValues::take() {
    if (is_words_) return {column_.name, std::move(labels_)};
    if (is_whole_) return {column_.name, std::move(wholes_)};
    return {column_.name, std::move(numbers_)};
}

PropertyTable::PropertyTable(const std::vector<PropertyColumn>& columns, const DataOptions& options, std::size_t count,
                             const std::string& file, Commas commas)
    : commas_(commas), count_(count), file_(file) {
    for (const PropertyColumn& column : columns) {
        names_.push_back(column.name);
        if (!is_wanted(options, column.name, count)) continue;
        values_.emplace_back(column, count);
        places_ = std::max(places_, column.place + (column.kind == PropertyKind::magnitude ? 3 : 1));
    }
    require_memory(values_.size() * count * sizeof(double), file + ": the values of " + in_groups(count) + " spheres need");
}

bool PropertyTable::wants_rows() const {
    return walks_ == 0 ? !values_.empty() : walks_ == 1 && std::ranges::any_of(values_, &PropertyValues::needs_words);
}

void PropertyTable::next_walk() {
    if (++walks_ == 1) return;
    for (PropertyValues& values : values_) {
        if (values.needs_words()) values.begin_again();
    }
}

double PropertyTable::magnitude(std::string_view x, std::string_view y, std::string_view z) {
    const auto square = [](std::string_view text) {
        const double number = value_in(text, Commas::none);
        return number * number;
    };
    const double length = square_root((square(x) + square(y)) + square(z));
    return std::isfinite(length) ? length : no_number;
}

FileProperties PropertyTable::take() {
    FileProperties properties{std::move(names_)};
    for (PropertyValues& values : values_) {
        const std::string& name = values.column().name;
        if (values.has_too_many_words()) {
            properties.warnings.push_back(file_ + ": " + in_quotes(name) + " has more than " +
                                          in_groups(PropertyValues::most_words) + " different words and is passed over");
            std::erase(properties.names, name);
            continue;
        }
        Property property = values.take();
        if (count_ == 0 || has_values(property)) {
            properties.kept.push_back(std::move(property));
        } else {
            std::erase(properties.names, name);
        }
    }
    return properties;
}

void add_properties(SphereData& data, FileProperties properties) {
    data.property_names = std::move(properties.names);
    data.scene.properties = std::move(properties.kept);
    data.warnings.insert(data.warnings.end(), properties.warnings.begin(), properties.warnings.end());
}

}  // namespace sphereview

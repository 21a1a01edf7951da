#include "formats/csv_choices.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/csv_columns.hpp"

namespace sphereview {

namespace {

std::optional<std::size_t> place_of(const std::string& choice, const ColumnNames& names) {
    const auto alike = [&](auto like) {
        const auto found = std::ranges::find_if(names, like);
        return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
    };
    if (const auto place = alike([&](const std::string& name) { return name == choice; })) return place;
    if (const auto place = alike([&](const std::string& name) { return lower_case(name) == lower_case(choice); })) return place;
    if (const auto place = alike([&](const std::string& name) { return column_key(name) == column_key(choice); })) return place;
    return std::nullopt;
}

std::optional<std::size_t> number_of(const std::string& choice, std::size_t fields) {
    std::size_t number = 0;
    return parse_whole(choice, number) && number >= 1 && number <= fields ? std::optional(number - 1) : std::nullopt;
}

}  // namespace

Chosen choose_columns(const ColumnNames& names, const std::vector<ColumnChoice>& choices) {
    Chosen chosen;
    chosen.columns = columns_by_name(names);
    std::size_t numbers = 0;
    for (const ColumnChoice& choice : choices) {
        const auto known = std::ranges::find(csv_column_names, choice.column);
        auto place = number_of(choice.field, names.size());
        if (place && (choice.column == "x" || choice.column == "y")) ++numbers;
        if (!place) place = place_of(choice.field, names);
        chosen.all_found = chosen.all_found && place.has_value();
        const auto column = static_cast<std::size_t>(known - csv_column_names.begin());
        for (auto& other : chosen.columns.places) {
            if (other == place) other.reset();  // what is asked for and what its name says
        }
        chosen.columns.places[column] = place;
        if (choice.column == "diameter") chosen.columns[CsvColumn::radius].reset();
    }
    chosen.places_by_number = numbers == 2;
    return chosen;
}

const ColumnChoice* missing_choice(const ColumnNames& names, const std::vector<ColumnChoice>& choices) {
    const auto missing = std::ranges::find_if(choices, [&](const ColumnChoice& choice) {
        return !number_of(choice.field, names.size()) && !place_of(choice.field, names);
    });
    return missing == choices.end() ? nullptr : &*missing;
}

std::optional<std::vector<ColumnChoice>> parse_column_choices(const std::string& text) {
    std::vector<ColumnChoice> choices;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        const std::string_view part = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::string column = lower_case(trimmed(part.substr(0, part.find('='))));
        if (part.find('=') != std::string_view::npos && std::ranges::find(csv_column_names, column) != csv_column_names.end()) {
            const auto same = std::ranges::find(choices, column, &ColumnChoice::column);
            if (same != choices.end()) return std::nullopt;
            choices.push_back({column, std::string(trimmed(part.substr(part.find('=') + 1)))});
        } else if (!choices.empty()) {
            choices.back().field += "," + std::string(part);
        } else {
            return std::nullopt;
        }
    }
    const auto is_named = [](const ColumnChoice& choice) { return !choice.field.empty(); };
    return !choices.empty() && std::ranges::all_of(choices, is_named) ? std::optional(choices) : std::nullopt;
}

}  // namespace sphereview

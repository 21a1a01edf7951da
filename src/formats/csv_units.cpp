#include "formats/csv_units.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "base/text.hpp"
#include "formats/csv_values.hpp"

namespace sphereview {

namespace {

struct KnownLength {
    std::string_view name;  // in small letters
    int power;              // 10 to it is the unit in metres
};

constexpr auto known_lengths = std::to_array<KnownLength>({
    {"fm", -15},
    {"pm", -12},
    {"a", -10},
    {"ang", -10},
    {"angstrom", -10},
    {"angstroms", -10},
    {"\xC3\xA5", -10},
    {"nm", -9},
    {"um", -6},
    {"\xC2\xB5m", -6},
    {"\xCE\xBCm", -6},
    {"micron", -6},
    {"microns", -6},
    {"mm", -3},
    {"cm", -2},
    {"m", 0},
    {"km", 3},
    {"\xC3\x85", -10},      // A with a ring, as a capital letter
    {"\xE2\x84\xAB", -10},  // and as a sign of its own
});

// Nothing for what is no length that is known: capital letters make a megametre and a petametre.
std::optional<int> power_of(std::string_view unit) {
    if (unit == "Mm" || unit == "Pm") return std::nullopt;
    const auto known = std::ranges::find(known_lengths, lower_case(unit), &KnownLength::name);
    return known == known_lengths.end() ? std::nullopt : std::optional(known->power);
}

bool are_same(const std::string& a, const std::string& b) {
    const auto power = power_of(a);
    return power || power_of(b) ? power == power_of(b) : lower_case(a) == lower_case(b);
}

}  // namespace

double CsvUnits::in_unit_of_places(double radius) const {
    // The powers of ten that a double holds exactly, as far as two known lengths lie apart.
    constexpr std::array powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                   1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
    const double factor = powers[static_cast<std::size_t>(std::abs(power))];
    return power < 0 ? radius / factor : radius * factor;
}

CsvUnits find_units(const ColumnNames& names, std::size_t first, const CsvColumns& columns, const ColumnNames& row_of_units) {
    const auto name_of = [&](CsvColumn column) -> std::string {
        const auto place = columns[column];
        return place && *place >= first && *place - first < names.size() ? names[*place - first] : "";
    };
    const auto unit_of = [&](CsvColumn column) -> std::string {
        std::string unit = unit_in(name_of(column));
        if (!unit.empty() || name_of(column).empty()) return unit;
        const std::size_t place = *columns[column] - first;
        if (place >= row_of_units.size()) return "";
        const std::string_view text = trimmed(row_of_units[place], " ()[]{}");
        return is_missing(text) ? "" : std::string(text);
    };
    const CsvColumn size = columns.has(CsvColumn::radius) ? CsvColumn::radius : CsvColumn::diameter;
    const std::string of_places = unit_of(CsvColumn::x);
    for (const CsvColumn column : {CsvColumn::y, CsvColumn::z}) {
        const std::string unit = unit_of(column);
        if (unit.empty() || of_places.empty() || are_same(unit, of_places)) continue;
        return {0, "x is in " + of_places + " and " + std::string(csv_column_names[static_cast<std::size_t>(column)]) + " in " +
                       unit + ": all numbers are taken as they are"};
    }
    const std::string of_radii = unit_of(size);
    if (of_radii.empty() || of_places.empty() || are_same(of_radii, of_places)) return {};
    const std::string differ = std::string(csv_column_names[static_cast<std::size_t>(size)]) + " is in " + of_radii +
                               " and the places in " + of_places + ": ";
    const auto from = power_of(of_radii);
    const auto to = power_of(of_places);
    if (!from || !to) return {0, differ + "all numbers are taken as they are"};
    return {*from - *to, differ + "the radii are converted to " + of_places};
}

}  // namespace sphereview

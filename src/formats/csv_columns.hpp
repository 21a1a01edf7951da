// Chooses the columns of a table that are drawn, by the names that programs give them and by --columns.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/sphere_data.hpp"

namespace sphereview {

enum class CsvColumn : std::size_t { x, y, z, radius, diameter, red, green, blue, color, element, name };
inline constexpr std::array<const char*, 11> csv_column_names = {"x", "y", "z",     "radius",  "diameter", "r",
                                                                 "g", "b", "color", "element", "name"};

// The field of a record that holds each column.
struct CsvColumns {
    std::array<std::optional<std::size_t>, csv_column_names.size()> places{};

    std::optional<std::size_t>& operator[](CsvColumn column) { return places[static_cast<std::size_t>(column)]; }
    const std::optional<std::size_t>& operator[](CsvColumn column) const { return places[static_cast<std::size_t>(column)]; }
    bool has(CsvColumn column) const { return (*this)[column].has_value(); }
};

using ColumnNames = std::vector<std::string>;

// A name in lower case without blanks, punctuation and unit, which differ among programs: "positionx" for "Position X [um]" and
// "POSITION_X".
std::string column_key(std::string_view name);

// Whether `text` is a unit of length, perhaps in brackets: "nm", "(um)".
bool is_unit(std::string_view text);

// The unit at the end of a column's name: "mm" for "X (mm)", "um" for "x_um"; "" where there is none. In round brackets only a
// known unit counts, since other words stand there, too.
std::string unit_in(std::string_view name);

// The drawn columns. A table needs x and y; has_places() tells whether these were found.
struct ChosenColumns {
    CsvColumns columns{};
    const ColumnChoice* missing = nullptr;  // the first choice that names no column
    bool places_by_number = false;          // x and y were chosen by number: no header is needed

    bool has_places() const { return missing == nullptr && columns.has(CsvColumn::x) && columns.has(CsvColumn::y); }
};
ChosenColumns choose_columns(const ColumnNames& names, const std::vector<ColumnChoice>& choices);

// Lets `choices` override the columns in `chosen`.
void apply_choices(const ColumnNames& names, const std::vector<ColumnChoice>& choices, ChosenColumns& chosen);

}  // namespace sphereview

// Which columns of a table are drawn: by the names that programs give them, and by --columns.
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

// Which field of a record each column is.
struct CsvColumns {
    std::array<std::optional<std::size_t>, csv_column_names.size()> places{};

    std::optional<std::size_t>& operator[](CsvColumn column) { return places[static_cast<std::size_t>(column)]; }
    const std::optional<std::size_t>& operator[](CsvColumn column) const { return places[static_cast<std::size_t>(column)]; }
    bool has(CsvColumn column) const { return (*this)[column].has_value(); }
};

using ColumnNames = std::vector<std::string>;

// A name without what differs from program to program: letter case, blanks, punctuation and the unit. "positionx" for
// "Position X [um]" and "POSITION_X".
std::string column_key(std::string_view name);

// Whether text is a unit of length, perhaps in brackets: "nm", "(um)".
bool is_unit(std::string_view text);

// The unit that a column's name ends with, as it stands there: "mm" for "X (mm)", "um" for "x_um"; "" where there is none. Round
// brackets hold other words, too: in them, only a known unit is one.
std::string unit_in(std::string_view name);

// The columns that are drawn among those with such names. Places may be missing: a table needs x and y.
struct ChosenColumns {
    CsvColumns columns{};
    const ColumnChoice* missing = nullptr;  // the first of the choices that names none of the columns
    bool places_by_number = false;          // x and y: then no header is needed

    bool has_places() const { return missing == nullptr && columns.has(CsvColumn::x) && columns.has(CsvColumn::y); }
};
ChosenColumns choose_columns(const ColumnNames& names, const std::vector<ColumnChoice>& choices);

// Puts what is chosen in the place of what `chosen` has.
void apply_choices(const ColumnNames& names, const std::vector<ColumnChoice>& choices, ChosenColumns& chosen);

}  // namespace sphereview

// The columns of LAMMPS's text dumps.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "formats/atom_lines.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"

namespace sphereview {

enum class DumpField { id, type, element, x, y, z, radius, diameter };

struct DumpColumn {
    DumpField field;
    std::size_t place;  // in the line, from 0
};

// The columns that are drawn, from left to right.
struct DumpColumns {
    std::vector<DumpColumn> columns{};
    std::vector<PropertyColumn> properties{};  // all but the drawn places
    std::array<bool, 3> scaled{};              // x, y and z are parts of the box's edges

    bool has(DumpField field) const { return std::ranges::find(columns, field, &DumpColumn::field) != columns.end(); }
    bool is_scaled() const { return std::ranges::find(scaled, true) != scaled.end(); }
    // Whether some axes are scaled and others not. A missing z is 0.
    bool is_mixed() const { return scaled[0] != scaled[1] || (has(DumpField::z) && scaled[1] != scaled[2]); }
};

// The names in the head of the atoms, `ITEM: ATOMS id type x y z`; none in old dumps.
std::vector<std::string_view> names_of_columns(std::string_view head);

// The columns by the head of the atoms, or, in old dumps, by the atoms' lines. Takes the first complete kind of places: plain, in
// parts of the box, and these two without jumps at its walls; else each axis' first. Throws InputError if there are no places.
DumpColumns dump_columns(const TextSource& source, std::string_view head, const AtomLines& lines);

}  // namespace sphereview

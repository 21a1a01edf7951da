// The columns of LAMMPS's dumps in text.
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
    std::vector<PropertyColumn> properties{};  // all but the places that are drawn
    std::array<bool, 3> scaled{};              // x, y and z are parts of the box's edges

    bool has(DumpField field) const { return std::ranges::find(columns, field, &DumpColumn::field) != columns.end(); }
    bool is_scaled() const { return std::ranges::find(scaled, true) != scaled.end(); }
    // Where z is missing it is 0, whatever the others are.
    bool is_mixed() const { return scaled[0] != scaled[1] || (has(DumpField::z) && scaled[1] != scaled[2]); }
};

// What the head of the atoms, `ITEM: ATOMS id type x y z`, names; old dumps name nothing.
std::vector<std::string_view> names_of_columns(std::string_view head);

// Which columns the head of the atoms names, or, in old dumps, the atoms' lines show. Of several kinds of places the first is taken
// of which all are there: as they are, in parts of the box, and the same two without the jumps at its walls; else of each axis the
// first. Throws InputError where there are no places.
DumpColumns dump_columns(const TextSource& source, std::string_view head, const AtomLines& lines);

}  // namespace sphereview

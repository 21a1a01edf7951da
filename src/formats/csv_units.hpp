// The units of lengths in a table: those of its radii need not be those of its places.
#pragma once

#include <cstddef>
#include <string>

#include "formats/csv_columns.hpp"

namespace sphereview {

struct CsvUnits {
    int power = 0;        // 10 to it is the unit of radii in that of places
    std::string words{};  // where the two differ: what was done about it

    // Rounds once: the power of ten itself is exact.
    double in_unit_of_places(double radius) const;
};

// Looks at the names in the header and at the row of units below it, by the header's names. `first`: the field that names[0] names.
CsvUnits find_units(const ColumnNames& names, std::size_t first, const CsvColumns& columns, const ColumnNames& row_of_units);

}  // namespace sphereview

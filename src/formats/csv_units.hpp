// The units of lengths in a table. Radii and places may have different units.
#pragma once

#include <cstddef>
#include <string>

#include "formats/csv_columns.hpp"

namespace sphereview {

struct CsvUnits {
    int power = 0;        // one unit of radii is 10^power units of places
    std::string words{};  // a message for the user where the units differ

    // Rounds once: the power of ten itself is exact.
    double in_unit_of_places(double radius) const;
};

// Looks at the names in the header and at the row of units below it, by the header's names. `first`: the field that names[0] names.
CsvUnits find_units(const ColumnNames& names, std::size_t first, const CsvColumns& columns, const ColumnNames& row_of_units);

}  // namespace sphereview

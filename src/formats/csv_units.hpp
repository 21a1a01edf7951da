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

// Reads the units from the header's names and the row of units. `first`: the field of names[0].
CsvUnits find_units(const ColumnNames& names, std::size_t first, const CsvColumns& columns, const ColumnNames& row_of_units);

}  // namespace sphereview

// The names that programs give to the columns of tables.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/csv_table.hpp"

namespace sphereview {

// A name without what differs from program to program: letter case, blanks, punctuation and the unit. "positionx" for
// "Position X [um]" and "POSITION_X".
std::string column_key(std::string_view name);

// The columns that are drawn among those with such names. Places may be missing: a table needs x and y.
CsvColumns columns_by_name(const std::vector<std::string>& names);

}  // namespace sphereview

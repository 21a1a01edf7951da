// The columns that --columns names, over what the header's names say.
#pragma once

#include <string>
#include <vector>

#include "formats/csv_table.hpp"

namespace sphereview {

using ColumnNames = std::vector<std::string>;

// The places in the fields that `choices` name, over what their names say.
struct Chosen {
    CsvColumns columns{};
    bool all_found = true;
    bool places_by_number = false;  // x and y: then no header is needed
};

Chosen choose_columns(const ColumnNames& names, const std::vector<ColumnChoice>& choices);

// The first choice that names none of these columns; null where each names one.
const ColumnChoice* missing_choice(const ColumnNames& names, const std::vector<ColumnChoice>& choices);

}  // namespace sphereview

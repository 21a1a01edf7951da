// What a table in text is: what divides it, which of its columns are drawn, and where its rows begin.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formats/csv_columns.hpp"
#include "formats/csv_records.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

struct CsvTable {
    CsvLayout layout{};
    std::size_t fields = 0;  // of each record
    CsvColumns columns{};
    std::size_t begin = 0;                     // of the first row
    bool has_header = true;                    // else what the columns are is a guess
    bool decimal_commas = false;               // 1,5 is a number
    bool colors_to_1 = false;                  // what the first rows show: red, green and blue are parts of 1
    std::vector<std::string> passed_over{};    // the names, or numbers from 1, of the other columns
    std::vector<PropertyColumn> properties{};  // all but places, colours and names
};

inline constexpr std::size_t most_csv_columns = 100'000;

// Finds the table in a text: behind titles and comments, with a header or rows of numbers alone. Throws InputError.
CsvTable find_csv_table(const TextSource& source, const std::vector<ColumnChoice>& choices);

// Whether a text that begins with `head` is clearly a table with places: no other format's text looks like it.
bool is_clearly_csv(std::string_view head);

}  // namespace sphereview

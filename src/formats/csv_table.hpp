// A table in text: its separator, the columns that are drawn, and where its rows begin.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/csv_columns.hpp"
#include "formats/csv_records.hpp"
#include "formats/csv_units.hpp"
#include "formats/csv_values.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// A column that is not drawn.
struct CsvPassedOver {
    std::string name;  // of its property, if it is one
    std::size_t place;
};

struct CsvTable {
    CsvLayout layout{};
    std::size_t fields = 0;  // of each record
    CsvColumns columns{};
    std::size_t begin = 0;                     // of the first row
    bool has_header = true;                    // else the columns are guessed
    bool guessed_places = false;               // x and y were found by the rows alone
    Commas commas = Commas::none;              // in numbers
    double full_color = color_max;             // what stands for 255 in red, green and blue, by the first rows
    bool packed_colors = false;                // a colour is one whole number; else hexadecimal
    bool atom_names = false;                   // the column of elements holds PDB's names of atoms
    std::optional<std::size_t> residue{};      // the column of these atoms' residues; else all are amino acids
    std::vector<CsvPassedOver> passed_over{};  // the other columns
    std::vector<std::size_t> rare{};           // ascending: the passed-over columns without a value in the first rows
    std::vector<PropertyColumn> properties{};  // all but places, colours and names
    ColumnNames row_of_units{};                // below the header; empty where there is none
    CsvUnits units{};
};

inline constexpr std::size_t most_csv_columns = 100'000;

// The rows of a table, from `begin` on.
inline CsvRecords rows_from(const TextSource& source, const CsvTable& table, std::size_t begin) {
    return CsvRecords(source, table.layout, begin, source.text.size(), table.fields + 1);
}

// Whether the record has a number, or a mark for a missing one, in x and in y, which `columns` must have.
bool is_row(const CsvRecords& record, const CsvColumns& columns);

inline constexpr std::size_t csv_rows_looked_at = 1000;

// Finds in the first rows what a header does not say: which columns hold colours and elements, how numbers are written, and which
// properties there are. `first`: the field of names[0].
void look_at_first_rows(const TextSource& source, const ColumnNames& names, std::size_t first,
                        const std::vector<ColumnChoice>& choices, CsvTable& table);

// Finds the table in a text, behind titles and comments, with or without a header. Throws InputError.
CsvTable find_csv_table(const TextSource& source, const std::vector<ColumnChoice>& choices);

// Whether a text that begins with `head` is clearly a table with places: no other format looks like this.
bool is_clearly_csv(std::string_view head);

}  // namespace sphereview

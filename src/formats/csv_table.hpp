// What a table in text is: what divides it, which of its columns are drawn, and where its rows begin.
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

// A column that nothing drawn is made of.
struct CsvPassedOver {
    std::string name;  // of its property, where it is one
    std::size_t place;
};

struct CsvTable {
    CsvLayout layout{};
    std::size_t fields = 0;  // of each record
    CsvColumns columns{};
    std::size_t begin = 0;                     // of the first row
    bool has_header = true;                    // else what the columns are is a guess
    bool guessed_places = false;               // rows alone say where x and y are
    Commas commas = Commas::none;              // in numbers
    double full_color = color_max;             // what the first rows show: what stands for 255 in red, green and blue
    bool packed_colors = false;                // a colour is one whole number, else hexadecimal
    bool atom_names = false;                   // the column of elements holds the names of atoms, as PDB has them
    std::optional<std::size_t> residue{};      // where these have their residues; else all are of amino acids
    std::vector<CsvPassedOver> passed_over{};  // the other columns
    std::vector<std::size_t> rare{};           // ascending: those of them that have no value in the first rows
    std::vector<PropertyColumn> properties{};  // all but places, colours and names
    ColumnNames row_of_units{};                // by the header's names; empty where there is no such row
    CsvUnits units{};
};

inline constexpr std::size_t most_csv_columns = 100'000;

// The rows of a table, from `begin` on.
inline CsvRecords rows_from(const TextSource& source, const CsvTable& table, std::size_t begin) {
    return CsvRecords(source, table.layout, begin, source.text.size(), table.fields + 1);
}

// Whether the record has numbers, or marks for none, where x and y are, of which each must have a place.
bool is_row(const CsvRecords& record, const CsvColumns& columns);

inline constexpr std::size_t csv_rows_looked_at = 1000;

// Looks at the first rows for what a header does not say: which of the columns hold colours and elements, how numbers are written,
// and what there is beside that. `first`: the field that names[0] names.
void look_at_first_rows(const TextSource& source, const ColumnNames& names, std::size_t first,
                        const std::vector<ColumnChoice>& choices, CsvTable& table);

// Finds the table in a text: behind titles and comments, with a header or rows of numbers alone. Throws InputError.
CsvTable find_csv_table(const TextSource& source, const std::vector<ColumnChoice>& choices);

// Whether a text that begins with `head` is clearly a table with places: no other format's text looks like it.
bool is_clearly_csv(std::string_view head);

}  // namespace sphereview

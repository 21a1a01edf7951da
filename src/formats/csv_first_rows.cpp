// What the first rows of a table in text show of its columns.
#include <algorithm>
#include <array>

#include "base/number.hpp"
#include "formats/csv_table.hpp"
#include "formats/csv_values.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

// A first column may hold names or colours that begin like comments.
void look_for_data_behind_marks(const TextSource& source, CsvTable& table) {
    const CsvLayout plain{table.layout.separator, table.layout.line_end, false};
    CsvRecords rows(source, plain, table.begin, source.text.size(), table.fields + 1);
    for (std::size_t i = 0; i < csv_rows_looked_at && rows.try_next(); ++i) {
        const bool marked = !rows.fields()[0].quoted && !comment_mark(rows.fields()[0].text).empty();
        if (!marked) continue;
        const bool is_data = rows.fields().size() == table.fields && table.columns[CsvColumn::x] != 0;
        if (is_data && is_row(rows, table.columns)) table.layout.comments = false;
        return;
    }
}

// Whether the column of elements is called so, and does not hold numbers or names of types.
bool surely_holds_elements(const std::string& name, const std::vector<ColumnChoice>& choices) {
    constexpr auto sure = std::to_array<std::string_view>({"element", "species", "symbol", "atomsymbol", "elementsymbol"});
    return std::ranges::find(sure, column_key(name)) != sure.end() ||
           std::ranges::find(choices, "element", &ColumnChoice::column) != choices.end();
}

// What the rows say that were looked at.
struct FirstRows {
    bool decimal_points = false;
    bool all_elements = true;  // where the column need not hold any
    bool any_element = false;
    bool any_hex_color = false;
    bool color_fractions = false;
    bool color_above_1 = false;
};

FirstRows first_rows(const TextSource& source, const CsvTable& table, bool surely_elements) {
    FirstRows found;
    CsvRecords rows = rows_from(source, table, table.begin);
    for (std::size_t i = 0; i < csv_rows_looked_at && rows.try_next(); ++i) {
        const auto field = [&](CsvColumn column) -> std::string_view {
            const auto place = table.columns[column];
            return place && *place < rows.fields().size() ? rows.fields()[*place].text : std::string_view();
        };
        for (const CsvColumn column : {CsvColumn::x, CsvColumn::y, CsvColumn::z}) {
            found.decimal_points = found.decimal_points || field(column).find('.') != std::string_view::npos;
        }
        if (const std::string_view element = field(CsvColumn::element); !is_missing(element)) {
            const bool known = surely_elements ? &element_of_species(element) != &unknown_element()
                                               : find_element(element) != nullptr && element[0] >= 'A' && element[0] <= 'Z';
            found.any_element = found.any_element || known;
            found.all_elements = found.all_elements && known;
        }
        found.any_hex_color = found.any_hex_color || parse_hex_color(field(CsvColumn::color));
        for (const CsvColumn column : {CsvColumn::red, CsvColumn::green, CsvColumn::blue}) {
            double value = 0.0;
            if (parse_csv_number(field(column), true, value) != NumberFault::none) continue;
            found.color_fractions = found.color_fractions || field(column).find_first_of(".,eE") != std::string_view::npos;
            found.color_above_1 = found.color_above_1 || value > 1.0;
        }
    }
    return found;
}

// `column`: what of the drawn it is.
void add_property(const std::string& name, std::size_t place, std::optional<CsvColumn> column, CsvTable& table) {
    if (column && *column != CsvColumn::radius && *column != CsvColumn::diameter && *column != CsvColumn::element) return;
    const std::string key = column_key(name);
    const PropertyKind kind = column == CsvColumn::element      ? PropertyKind::element
                              : key == "type" || key == "chain" ? PropertyKind::words
                                                                : PropertyKind::found;
    const bool is_element = column == CsvColumn::element && key != "type";
    add_column(table.properties, is_element ? "element" : table.has_header ? name : "column" + name, kind, place);
}

}  // namespace

void look_at_first_rows(const TextSource& source, const ColumnNames& names, std::size_t first,
                        const std::vector<ColumnChoice>& choices, CsvTable& table) {
    CsvColumns& columns = table.columns;
    if (columns.has(CsvColumn::radius)) columns[CsvColumn::diameter].reset();
    look_for_data_behind_marks(source, table);
    const std::size_t element = columns[CsvColumn::element].value_or(first) - first;
    const bool surely_elements = surely_holds_elements(element < names.size() ? names[element] : "", choices);
    const FirstRows found = first_rows(source, table, surely_elements);
    table.decimal_commas = !found.decimal_points;
    table.colors_to_1 = found.color_fractions && !found.color_above_1;
    if (!found.any_element || !(surely_elements || found.all_elements)) columns[CsvColumn::element].reset();
    if (!found.any_hex_color || columns.has(CsvColumn::red)) columns[CsvColumn::color].reset();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto drawn = std::ranges::find(columns.places, std::optional(first + i));
        const bool is_drawn = drawn != columns.places.end();
        if (!is_drawn && !names[i].empty()) table.passed_over.push_back(names[i]);
        const auto column = is_drawn ? std::optional(static_cast<CsvColumn>(drawn - columns.places.begin())) : std::nullopt;
        add_property(names[i], first + i, column, table);
    }
}

}  // namespace sphereview

// What the first rows of a table in text show of its columns.
#include <algorithm>
#include <array>
#include <cmath>

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

// Whether a column of that name holds numbers of elements, unless one of them is none.
bool may_hold_atomic_numbers(const std::string& name) { return name == "Z" || column_key(name) == "atomicnumber"; }

// Whether the column of elements is called so, and does not hold numbers or names of types.
bool surely_holds_elements(const std::string& name, const std::vector<ColumnChoice>& choices) {
    constexpr auto sure = std::to_array<std::string_view>({"element", "species", "symbol", "atomsymbol", "elementsymbol"});
    return std::ranges::find(sure, column_key(name)) != sure.end() ||
           std::ranges::find(choices, "element", &ColumnChoice::column) != choices.end();
}

// What the rows show of commas in numbers: only quotes hold them where a comma separates.
class CommasSeen {
public:
    void look_at(const CsvField& field) {
        double ignored = 0.0;
        if (field.text.find(',') == std::string_view::npos) return;
        if (parse_csv_number(field.text, Commas::thousands, ignored) == NumberFault::none) {
            thousands_ = true;
        } else if (parse_csv_number(field.text, Commas::decimal, ignored) == NumberFault::none) {
            decimals_ = true;
        }
    }

    // points: numbers have them.
    Commas commas(char separator, bool points) const {
        if (separator == ',' && (points || (thousands_ && !decimals_))) return Commas::thousands;
        return points ? Commas::none : Commas::decimal;
    }

private:
    bool thousands_ = false;
    bool decimals_ = false;
};

// What a column of colours holds.
class ColorsSeen {
public:
    void look_at(std::string_view text) {
        if (is_missing(text)) return;
        const bool is_hex = parse_hex_color(text).has_value();
        any_mark_ = any_mark_ || (is_hex && has_hex_mark(text));
        all_hex_ = all_hex_ && is_hex;
        // No decimal number is written so.
        any_letter_ = any_letter_ || text[0] == '0' || text.find_first_not_of("0123456789") != std::string_view::npos;
        double value = 0.0;
        all_packed_ = all_packed_ && parse_packed_color(text) && parse_double(text, value) == NumberFault::none;
        largest_ = std::max(largest_, std::fabs(value));
        any_ = true;
    }

    // surely: the column was chosen for it.
    bool is_hex(bool surely) const { return any_mark_ || (any_ && all_hex_ && (any_letter_ || surely)); }
    bool is_packed() const { return any_ && all_packed_ && largest_ > color_max; }

private:
    bool any_ = false;
    bool any_mark_ = false;
    bool any_letter_ = false;
    bool all_hex_ = true;
    bool all_packed_ = true;
    double largest_ = 0.0;
};

// How often the atoms of a backbone stand in a column: where each of its residues has a CA, that is no calcium.
struct BackboneSeen {
    std::size_t n = 0;
    std::size_t ca = 0;
    std::size_t c = 0;
    std::size_t o = 0;
    bool any_word = false;  // and not only numbers of atoms

    void look_at(std::string_view name) {
        any_word = any_word || is_letter(name[0]);
        n += name == "N" ? 1 : 0;
        ca += name == "CA" ? 1 : 0;
        c += name == "C" ? 1 : 0;
        o += name == "O" ? 1 : 0;
    }
    bool is_one() const { return ca > 0 && c > 0 && o > 0 && n > 0 && 2 * ca >= n; }
};

// What the rows say that were looked at.
struct FirstRows {
    bool decimal_points = false;
    bool all_elements = true;  // where the column need not hold any
    bool any_element = false;
    double largest_color = 0.0;
    CommasSeen commas{};
    ColorsSeen colors{};
    BackboneSeen backbone{};
    std::vector<bool> has_value{};  // by field
};

// any_species: the column of elements holds all that element_of_species() knows; else symbols alone.
FirstRows first_rows(const TextSource& source, const CsvTable& table, bool any_species) {
    FirstRows found;
    found.has_value.resize(table.fields);
    CsvRecords rows = rows_from(source, table, table.begin);
    for (std::size_t i = 0; i < csv_rows_looked_at && rows.try_next(); ++i) {
        const auto fields = rows.fields();
        for (std::size_t place = 0; place < std::min(fields.size(), table.fields); ++place) {
            if (fields[place].quoted) found.commas.look_at(fields[place]);
            if (!found.has_value[place] && !is_missing(fields[place].text)) found.has_value[place] = true;
        }
        const auto field = [&](CsvColumn column) -> std::string_view {
            const auto place = table.columns[column];
            return place && *place < rows.fields().size() ? rows.fields()[*place].text : std::string_view();
        };
        for (const CsvColumn column : {CsvColumn::x, CsvColumn::y, CsvColumn::z}) {
            found.decimal_points = found.decimal_points || field(column).find('.') != std::string_view::npos;
        }
        if (const std::string_view element = field(CsvColumn::element); !is_missing(element)) {
            found.backbone.look_at(element);
            const bool known = any_species ? &element_of_species(element) != &unknown_element()
                                           : find_element(element) != nullptr && element[0] >= 'A' && element[0] <= 'Z';
            found.any_element = found.any_element || known;
            found.all_elements = found.all_elements && known;
        }
        found.colors.look_at(field(CsvColumn::color));
        for (const CsvColumn column : {CsvColumn::red, CsvColumn::green, CsvColumn::blue}) {
            double value = 0.0;
            const bool is_number = parse_csv_number(field(column), Commas::decimal, value) == NumberFault::none;
            if (is_number && value <= most_of_color) found.largest_color = std::max(found.largest_color, value);
        }
    }
    return found;
}

// A column of the names of atoms holds elements where their residues stand in another, or where they are a backbone's.
void look_for_atom_names(const ColumnNames& names, const std::string& element, std::size_t first, const BackboneSeen& seen,
                         CsvTable& table) {
    const std::string key = column_key(element);
    if ((key != "atom" && key != "atomname") || !seen.any_word) return;
    constexpr auto residues = std::to_array<std::string_view>({"resname", "residuename", "resn", "residue", "restype"});
    for (const std::string_view residue : residues) {
        const auto found = std::ranges::find(names, residue, column_key);
        if (found == names.end()) continue;
        table.residue = first + static_cast<std::size_t>(found - names.begin());
        break;
    }
    table.atom_names = seen.is_one() || table.residue;
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
    const auto name_of = [&](CsvColumn column) -> std::string {
        const std::size_t place = columns[column].value_or(first) - first;
        return columns.has(column) && place < names.size() ? names[place] : "";
    };
    const bool surely_elements = surely_holds_elements(name_of(CsvColumn::element), choices);
    const bool any_species = surely_elements || may_hold_atomic_numbers(name_of(CsvColumn::element));
    const FirstRows found = first_rows(source, table, any_species);
    table.commas = found.commas.commas(table.layout.separator, found.decimal_points);
    if (found.largest_color > 0.0) table.full_color = full_color(found.largest_color);
    look_for_atom_names(names, name_of(CsvColumn::element), first, found.backbone, table);
    if (!table.atom_names && (!found.any_element || !(surely_elements || found.all_elements))) columns[CsvColumn::element].reset();
    const bool surely_colors = std::ranges::find(choices, "color", &ColumnChoice::column) != choices.end();
    const bool is_hex = found.colors.is_hex(surely_colors);
    table.packed_colors = !is_hex && found.colors.is_packed() && (surely_colors || column_key(name_of(CsvColumn::color)) == "rgb");
    if (!(is_hex || table.packed_colors) || columns.has(CsvColumn::red)) columns[CsvColumn::color].reset();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto drawn = std::ranges::find(columns.places, std::optional(first + i));
        const bool is_drawn = drawn != columns.places.end();
        if (!is_drawn && (first + i >= found.has_value.size() || !found.has_value[first + i])) table.rare.push_back(first + i);
        const auto column = is_drawn ? std::optional(static_cast<CsvColumn>(drawn - columns.places.begin())) : std::nullopt;
        const std::size_t properties = table.properties.size();
        add_property(names[i], first + i, column, table);
        if (is_drawn || names[i].empty()) continue;
        const bool is_property = table.properties.size() > properties;
        table.passed_over.push_back({is_property ? table.properties.back().name : names[i], first + i});
    }
    table.units = find_units(names, first, table.columns, table.row_of_units);
}

}  // namespace sphereview

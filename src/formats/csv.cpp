#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atom_names.hpp"
#include "formats/atoms.hpp"
#include "formats/csv_table.hpp"
#include "formats/csv_values.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/point_radius.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

constexpr double usual_radius = 1.0;

// What rows hold beside their spheres.
struct RowNotes {
    std::size_t radii = 0;                      // rows with a radius of their own
    std::size_t no_center = 0;                  // rows that were left out
    std::size_t odd = 0;                        // rows whose radius or colour is none and does not say so
    double largest_color = 0.0;                 // of red, green and blue
    std::vector<std::size_t> virtual_sites{};   // which of the spheres are no atoms
    std::vector<std::size_t> values_of_rare{};  // of each of CsvTable::rare, in how many rows there is a value

    // `first`: the number of the first of the other's spheres.
    void add(const RowNotes& other, std::size_t first) {
        radii += other.radii;
        no_center += other.no_center;
        odd += other.odd;
        largest_color = std::max(largest_color, other.largest_color);
        for (const std::size_t site : other.virtual_sites) virtual_sites.push_back(first + site);
        for (std::size_t i = 0; i < other.values_of_rare.size(); ++i) values_of_rare[i] += other.values_of_rare[i];
    }
};

// The spheres of one piece.
struct Spheres {
    std::vector<Sphere> spheres{};
    std::vector<std::pair<std::size_t, std::string>> names{};
    RowNotes notes{};
};

// Reads the fields of a record.
class RowReader {
public:
    // full_color: what stands for 255 in red, green and blue. names_elements: an atom without a name gets its element's.
    RowReader(const CsvRecords& records, const CsvTable& table, const DataOptions& options, double full_color, bool names_elements)
        : records_(records), table_(table), options_(options), full_color_(full_color), names_elements_(names_elements) {}

    // Appends the record's sphere and name, unless it has no centre.
    void read(Spheres& read) const {
        // A separator at the end of the line is common, and no field.
        const std::span<const CsvField> fields = records_.fields();
        const bool one_empty = fields.size() == table_.fields + 1 && fields.back().text.empty();
        if (fields.size() > table_.fields && !one_empty) {
            records_.fail(fields[table_.fields],
                          "the end of the line after " + std::to_string(table_.fields) + " fields, as the header has them");
        }
        Sphere sphere;
        if (!read_center(sphere.center)) {
            const auto is_empty = [](const CsvField& field) { return field.text.empty(); };
            if (!std::ranges::all_of(fields, is_empty)) ++read.notes.no_center;  // spreadsheets end with empty rows
            return;
        }
        const Element* element = has(CsvColumn::element) ? &element_of_row() : nullptr;
        bool odd = false;
        if (!set_radius(sphere.radius, odd)) {
            sphere.radius = element == nullptr ? options_.radius.value_or(usual_radius) : radius_of(*element, options_);
        } else {
            ++read.notes.radii;
        }
        if (!set_color(sphere.color, read.notes.largest_color, odd) && element != nullptr) sphere.color = element->color;
        if (odd) ++read.notes.odd;
        if (element != nullptr && is_virtual(*element)) read.notes.virtual_sites.push_back(read.spheres.size());
        look_at_rare(read.notes.values_of_rare);
        read.spheres.push_back(sphere);
        std::string name = name_of_row();
        if (!name.empty()) read.names.emplace_back(read.spheres.size() - 1, std::move(name));
    }

    // For a table with a column of elements or names of atoms.
    const Element& element_of_row() const {
        const std::string_view text = field(CsvColumn::element).text;
        if (!table_.atom_names) return element_of_species(text);
        const auto residue = table_.residue;
        const bool has_residue = residue && *residue < records_.fields().size();
        return element_of_name(text, has_residue ? records_.fields()[*residue].text : any_amino_acid, NameColumns::unknown);
    }

    // False where the row has none.
    bool read_center(glm::dvec3& center) const {
        center = glm::dvec3(0.0);
        return number(CsvColumn::x, center.x) && number(CsvColumn::y, center.y) &&
               (!has(CsvColumn::z) || number(CsvColumn::z, center.z));
    }

private:
    static constexpr std::string_view any_amino_acid = "ALA";  // CA is carbon in each

    static std::string name_of(CsvColumn column) { return csv_column_names[static_cast<std::size_t>(column)]; }

    bool has(CsvColumn column) const { return table_.columns.has(column); }

    // The column must exist.
    const CsvField& field(CsvColumn column) const {
        const std::size_t place = *table_.columns[column];
        if (place >= records_.fields().size()) records_.fail_at_end(name_of(column));
        return records_.fields()[place];
    }

    // False where the field holds no number and says so.
    bool number(CsvColumn column, double& value) const {
        const CsvField& text = field(column);
        return parse_double(text.text, value) == NumberFault::none || odd_number(column, text, value);
    }

    bool odd_number(CsvColumn column, const CsvField& text, double& value) const {
        const NumberFault fault = parse_csv_number(text.text, table_.commas, value);
        if (fault == NumberFault::none) return true;
        if (stands_for_none(text.text, fault)) return false;
        records_.fail(text, name_of(column) + ", " + expected_instead_of(fault));
    }

    // False where the row says none: also by 0, which OVITO writes for it, and by what is no radius, which is odd.
    bool set_radius(double& radius, bool& odd) const {
        const bool has_radius = has(CsvColumn::radius);
        if (!has_radius && !has(CsvColumn::diameter)) return false;
        const std::string_view text = field(has_radius ? CsvColumn::radius : CsvColumn::diameter).text;
        double value = 0.0;
        const bool is_number =
            parse_double(text, value) == NumberFault::none || parse_csv_number(text, table_.commas, value) == NumberFault::none;
        odd = odd || (is_number ? value < 0.0 : !is_missing(text));
        if (!is_number) return false;
        radius = table_.units.in_unit_of_places(has_radius ? value : 0.5 * value);
        const bool is_finite = std::isfinite(radius);
        odd = odd || !is_finite;
        return is_finite && radius > 0.0;
    }

    bool set_color(Color& color, double& largest, bool& odd) const {
        if (has(CsvColumn::color)) {
            const std::string_view text = field(CsvColumn::color).text;
            const auto found = table_.packed_colors ? parse_packed_color(text) : parse_hex_color(text);
            if (found) color = *found;
            odd = odd || (!found && !is_missing(text));
            return found.has_value();
        }
        if (!has(CsvColumn::red)) return false;
        Color read;
        if (!set_channel(CsvColumn::red, read.r, largest, odd) || !set_channel(CsvColumn::green, read.g, largest, odd) ||
            !set_channel(CsvColumn::blue, read.b, largest, odd)) {
            return false;
        }
        color = read;
        return true;
    }

    bool set_channel(CsvColumn column, std::uint8_t& channel, double& largest, bool& odd) const {
        const std::string_view text = field(column).text;
        const auto byte = parse_color_byte(text, full_color_, largest);
        odd = odd || (!byte && !is_missing(text));
        channel = byte.value_or(0);
        return byte.has_value();
    }

    void look_at_rare(std::vector<std::size_t>& counts) const {
        if (table_.rare.empty()) return;
        counts.resize(table_.rare.size());
        const auto fields = records_.fields();
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const std::size_t place = table_.rare[i];
            if (place < fields.size() && !is_missing(fields[place].text)) ++counts[i];
        }
    }

    std::string name_of_row() const {
        if (has(CsvColumn::name)) return as_utf8(unquoted(field(CsvColumn::name)));
        return names_elements_ ? name_of_species(field(CsvColumn::element).text) : "";
    }

    const CsvRecords& records_;
    const CsvTable& table_;
    const DataOptions& options_;
    double full_color_;
    bool names_elements_;
};

// Where pieces of the text from `begin` on begin, at the beginning of a line, and where the last ends.
std::vector<std::size_t> piece_places(std::string_view text, std::size_t begin, char line_end) {
    std::vector<std::size_t> places = {begin};
    while (text.size() - places.back() > usual_line_piece) {
        const std::size_t end = text.find(line_end, places.back() + usual_line_piece);
        if (end == std::string_view::npos) break;
        places.push_back(end + 1);
    }
    places.push_back(text.size());
    return places;
}

// How many records there can be, but for odd ones that quotes spread over short lines.
std::size_t most_records(std::string_view text, const std::vector<std::size_t>& places, char line_end) {
    constexpr std::size_t shortest_record = std::string_view("0,0,0").size();
    std::vector<std::size_t> counts(places.size() - 1);
    parallel_for(counts.size(), [&](std::size_t i) {
        for (LineWalker lines(text.substr(0, places[i + 1]), line_end, places[i]); !lines.at_end();) {
            if (lines.step().size() >= shortest_record) ++counts[i];
        }
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// Reads the rows of a table, once the table is found.
class RowsReader {
public:
    RowsReader(const TextSource& source, const CsvTable& table, const DataOptions& options)
        : source_(source),
          table_(table),
          options_(options),
          places_(piece_places(source.text, table.begin, table.layout.line_end)) {
        // Beside the text: the spheres, and for each name an entry of a map.
        constexpr std::size_t bytes_per_name = 112;
        most_ = most_records(source.text, places_, table.layout.line_end);
        names_elements_ = table.columns.has(CsvColumn::element) && most_ <= most_named_atoms;
        const bool has_names = table.columns.has(CsvColumn::name) || names_elements_;
        const std::size_t bytes_of_names = has_names ? most_ * bytes_per_name + source.text.size() : 0;
        require_memory(most_ * sizeof(Sphere) + bytes_of_names, source.name + ": up to " + in_groups(most_) + " spheres need");
    }

    // Replaces the scene.
    RowNotes read(Scene& scene, double full_color) const {
        scene = {};
        scene.spheres.reserve(most_);
        RowNotes notes;
        notes.values_of_rare.resize(table_.rare.size());
        if (source_.text.find('"', table_.begin) != std::string_view::npos) {
            // Whether a quote opens or closes a field only its line's beginning tells, and that of the line before it.
            constexpr std::size_t rows_at_once = 4096;
            CsvRecords records = rows_from(source_, table_, table_.begin);
            bool more = true;
            while (more) append(scene, read_records(records, full_color, rows_at_once, more), notes);
            return notes;
        }
        const std::size_t pieces_at_once = 4 * static_cast<std::size_t>(worker_count());
        for (std::size_t done = 0; done + 1 < places_.size(); done += pieces_at_once) {
            std::vector<Spheres> pieces(std::min(pieces_at_once, places_.size() - 1 - done));
            parallel_in_order(pieces.size(), [&](std::size_t i) {
                // With the field behind a separator at the line's end.
                CsvRecords records(source_, table_.layout, places_[done + i], places_[done + i + 1], table_.fields + 1);
                bool more = false;
                pieces[i] = read_records(records, full_color, std::numeric_limits<std::size_t>::max(), more);
            });
            for (Spheres& piece : pieces) append(scene, std::move(piece), notes);
        }
        return notes;
    }

    // The values of the spheres, `count` of them, that were read.
    FileProperties read_properties_of(std::size_t count) const {
        const auto walk = [&](PropertyTable& properties) {
            CsvRecords records = rows_from(source_, table_, table_.begin);
            const RowReader row(records, table_, options_, color_max, false);
            glm::dvec3 ignored;
            std::string text;
            while (records.next()) {
                if (!row.read_center(ignored)) continue;
                const auto fields = records.fields();
                properties.add([&](std::size_t place) -> std::string_view {
                    if (place >= fields.size()) return {};
                    if (table_.atom_names && place == table_.columns[CsvColumn::element])
                        return symbol_or_name(row.element_of_row(), fields[place].text);
                    if (!fields[place].quoted) return fields[place].text;
                    text = unquoted(fields[place]);
                    return text;
                });
            }
        };
        return read_properties(table_.properties, options_, count, source_.name, walk, table_.commas);
    }

private:
    Spheres read_records(CsvRecords& records, double full_color, std::size_t most, bool& more) const {
        Spheres read;
        const RowReader row(records, table_, options_, full_color, names_elements_);
        more = true;
        for (std::size_t i = 0; i < most && more; ++i) {
            more = records.next();
            if (more) row.read(read);
        }
        return read;
    }

    void append(Scene& scene, Spheres read, RowNotes& notes) const {
        const std::size_t first = scene.spheres.size();
        const std::size_t count = first + read.spheres.size();
        if (count > most_spheres) {
            throw InputError(source_.name + ": found " + in_groups(count) + " spheres, expected at most " +
                             in_groups(most_spheres));
        }
        scene.spheres.insert(scene.spheres.end(), read.spheres.begin(), read.spheres.end());
        for (auto& [index, text] : read.names) {
            scene.names.emplace_hint(scene.names.end(), static_cast<std::uint32_t>(first + index), std::move(text));
        }
        notes.add(read.notes, first);
    }

    const TextSource& source_;
    const CsvTable& table_;
    const DataOptions& options_;
    std::vector<std::size_t> places_;  // where pieces of the text begin, and where the last ends
    std::size_t most_ = 0;             // rows
    bool names_elements_ = false;
};

// What to say of a column that is not there.
std::string passed_over_in_words(const CsvTable& table, const DataOptions& options) {
    std::vector<std::string> columns;
    for (const CsvPassedOver& column : table.passed_over) {
        if (!is_wanted(options, column.name, 0)) columns.push_back(in_quotes(column.name));
    }
    if (columns.empty()) return "";
    constexpr std::size_t most_listed = 20;
    return "columns that are passed over: " + joined(first_of(std::move(columns), most_listed), ", ") +
           "; --color-by and --size-by can use them";
}

// Columns in which nothing stands are of no use to anybody.
void forget_empty_columns(CsvTable& table, const RowNotes& notes) {
    std::vector<std::size_t> empty;
    for (std::size_t i = 0; i < table.rare.size(); ++i) {
        if (notes.values_of_rare[i] == 0) empty.push_back(table.rare[i]);
    }
    const auto is_empty = [&](const auto& column) { return std::ranges::binary_search(empty, column.place); };
    std::erase_if(table.passed_over, is_empty);
    std::erase_if(table.properties, is_empty);
}

void warn_of_odd(SphereData& data, std::size_t rows, const std::string& name) {
    if (rows == 0) return;
    data.warnings.push_back(name + ": " + in_groups(rows) + (rows == 1 ? " row has" : " rows have") +
                            " a radius or colour that is none, and " + (rows == 1 ? "gets" : "get") + " the usual one");
}

}  // namespace

bool shows_csv(std::string_view head) { return is_clearly_csv(is_utf16(head) ? utf8_of_utf16(head) : std::string(head)); }

SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options) {
    const std::string converted = is_utf16(content) ? utf8_of_utf16(content) : "";
    const TextSource source{name, text_of_file(converted.empty() ? content : std::string_view(converted))};
    CsvTable table = find_csv_table(source, options.columns);
    const RowsReader rows(source, table, options);
    SphereData data;
    RowNotes notes = rows.read(data.scene, table.full_color);
    // What the first rows show of the colours need not hold for all of them.
    const double full = full_color(notes.largest_color);
    if (full != table.full_color && notes.largest_color > 0.0) notes = rows.read(data.scene, full);

    forget_empty_columns(table, notes);
    add_properties(data, rows.read_properties_of(data.scene.spheres.size()));
    if (table.guessed_places) {
        const auto is_guessed = [&](CsvColumn column, std::string_view in_choices) {
            return table.columns.has(column) &&
                   std::ranges::find(options.columns, in_choices, &ColumnChoice::column) == options.columns.end();
        };
        data.warnings.push_back(name + ": no header: the first columns are taken for x, y" +
                                std::string(is_guessed(CsvColumn::z, "z") ? " and z" : "") +
                                (is_guessed(CsvColumn::red, "r") ? ", and three more for red, green and blue" : ""));
    }
    if (!table.units.words.empty()) data.warnings.push_back(name + ": " + table.units.words);
    if (!table.columns.has(CsvColumn::z)) data.warnings.push_back(name + ": no column for z: all lie in the plane z = 0");
    warn_of_left_out(data, notes.no_center, name, "row", "rows");
    warn_of_odd(data, notes.odd, name);
    settle_virtual_sites(data, notes.virtual_sites, name, options);
    if (notes.radii == 0 && !table.columns.has(CsvColumn::element)) use_radius_of_points(data, name, options);
    if (const std::string words = passed_over_in_words(table, options); !words.empty()) data.notes.push_back(name + ": " + words);
    return data;
}

}  // namespace sphereview

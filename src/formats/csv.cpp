#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
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

// What rows hold beside their spheres, counted.
struct RowCounts {
    std::size_t radii = 0;         // rows with a radius of their own
    std::size_t no_center = 0;     // rows that were left out
    bool color_fractions = false;  // a red, green or blue is written as 0.5 or 255.0
    bool color_above_1 = false;

    RowCounts& operator+=(const RowCounts& other) {
        radii += other.radii;
        no_center += other.no_center;
        color_fractions = color_fractions || other.color_fractions;
        color_above_1 = color_above_1 || other.color_above_1;
        return *this;
    }
};

// The spheres of one piece.
struct Spheres {
    std::vector<Sphere> spheres{};
    std::vector<std::pair<std::size_t, std::string>> names{};
    RowCounts counts{};
};

// Reads the fields of a record.
class RowReader {
public:
    // colors_to_1: red, green and blue are parts of 1; else of 255. names_elements: an atom without a name gets its element's.
    RowReader(const CsvRecords& records, const CsvTable& table, const DataOptions& options, bool colors_to_1, bool names_elements)
        : records_(records), table_(table), options_(options), colors_to_1_(colors_to_1), names_elements_(names_elements) {
        std::ranges::transform(table.columns.places, places_.begin(), [](const auto& place) { return place.value_or(nowhere); });
    }

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
            if (!std::ranges::all_of(fields, is_empty)) ++read.counts.no_center;  // spreadsheets end with empty rows
            return;
        }
        const Element* element = has(CsvColumn::element) ? &element_of_species(field(CsvColumn::element).text) : nullptr;
        if (!set_radius(sphere.radius)) {
            sphere.radius = element == nullptr ? options_.radius.value_or(usual_radius) : radius_of(*element, options_);
        } else {
            ++read.counts.radii;
        }
        if (!set_color(sphere.color, read.counts) && element != nullptr) sphere.color = element->color;
        read.spheres.push_back(sphere);
        std::string name = name_of_row();
        if (!name.empty()) read.names.emplace_back(read.spheres.size() - 1, std::move(name));
    }

    // False where the row has none.
    bool read_center(glm::dvec3& center) const {
        center = glm::dvec3(0.0);
        return number(CsvColumn::x, center.x) && number(CsvColumn::y, center.y) &&
               (!has(CsvColumn::z) || number(CsvColumn::z, center.z));
    }

private:
    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

    static std::string name_of(CsvColumn column) { return csv_column_names[static_cast<std::size_t>(column)]; }

    bool has(CsvColumn column) const { return places_[static_cast<std::size_t>(column)] != nowhere; }

    const CsvField& field(CsvColumn column) const {
        const std::size_t place = places_[static_cast<std::size_t>(column)];
        if (place >= records_.fields().size()) records_.fail_at_end(name_of(column));
        return records_.fields()[place];
    }

    // False where the field holds no number and says so.
    bool number(CsvColumn column, double& value) const {
        const CsvField& text = field(column);
        return parse_double(text.text, value) == NumberFault::none || odd_number(column, text, value);
    }

    bool odd_number(CsvColumn column, const CsvField& text, double& value) const {
        if (is_missing(text.text)) return false;
        const NumberFault fault = parse_csv_number(text.text, table_.decimal_commas, value);
        if (fault == NumberFault::none) return true;
        records_.fail(text, name_of(column) + ", " + expected_instead_of(fault));
    }

    // False where the row says none: also by 0, which OVITO writes for it.
    bool set_radius(double& radius) const {
        const bool has_radius = has(CsvColumn::radius);
        if (!has_radius && !has(CsvColumn::diameter)) return false;
        const CsvColumn column = has_radius ? CsvColumn::radius : CsvColumn::diameter;
        double value = 0.0;
        if (!number(column, value)) return false;
        if (value < 0.0) records_.fail(field(column), name_of(column) + " above 0");
        radius = has_radius ? value : 0.5 * value;
        return radius > 0.0;
    }

    bool set_color(Color& color, RowCounts& counts) const {
        if (has(CsvColumn::color)) {
            const auto found = parse_hex_color(field(CsvColumn::color).text);
            if (found) color = *found;
            return found.has_value();
        }
        if (!has(CsvColumn::red)) return false;
        Color read;
        if (!set_channel(CsvColumn::red, read.r, counts) || !set_channel(CsvColumn::green, read.g, counts) ||
            !set_channel(CsvColumn::blue, read.b, counts)) {
            return false;
        }
        color = read;
        return true;
    }

    bool set_channel(CsvColumn column, std::uint8_t& channel, RowCounts& counts) const {
        const CsvField& text = field(column);
        if (!parse_whole(text.text, channel)) return set_odd_channel(column, text, channel, counts);
        counts.color_above_1 |= channel > 1;
        if (colors_to_1_ && channel > 0) channel = color_max;
        return true;
    }

    bool set_odd_channel(CsvColumn column, const CsvField& text, std::uint8_t& channel, RowCounts& counts) const {
        if (is_missing(text.text)) return false;
        double value = 0.0;
        const NumberFault fault = parse_csv_number(text.text, true, value);
        if (fault != NumberFault::none || !(value >= 0.0 && value <= color_max)) {
            records_.fail(text, name_of(column) + ", a whole number from 0 to 255");
        }
        counts.color_fractions = true;
        counts.color_above_1 |= value > 1.0;
        channel = static_cast<std::uint8_t>(std::lround(colors_to_1_ ? color_max * std::min(1.0, value) : value));
        return true;
    }

    std::string name_of_row() const {
        if (has(CsvColumn::name)) return as_utf8(unquoted(field(CsvColumn::name)));
        return names_elements_ ? name_of_species(field(CsvColumn::element).text) : "";
    }

    const CsvRecords& records_;
    const CsvTable& table_;
    const DataOptions& options_;
    bool colors_to_1_;
    bool names_elements_;
    std::array<std::size_t, csv_column_names.size()> places_{};  // of the columns among the fields, for each row
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
    RowCounts read(Scene& scene, bool colors_to_1) const {
        scene = {};
        scene.spheres.reserve(most_);
        RowCounts counts;
        if (source_.text.find('"', table_.begin) != std::string_view::npos) {
            // Whether a quote opens or closes a field only its line's beginning tells, and that of the line before it.
            constexpr std::size_t rows_at_once = 4096;
            CsvRecords records = rows_from(source_, table_, table_.begin);
            bool more = true;
            while (more) counts += append(scene, read_records(records, colors_to_1, rows_at_once, more));
            return counts;
        }
        const std::size_t pieces_at_once = 4 * static_cast<std::size_t>(worker_count());
        for (std::size_t done = 0; done + 1 < places_.size(); done += pieces_at_once) {
            std::vector<Spheres> pieces(std::min(pieces_at_once, places_.size() - 1 - done));
            parallel_in_order(pieces.size(), [&](std::size_t i) {
                // With the field behind a separator at the line's end.
                CsvRecords records(source_, table_.layout, places_[done + i], places_[done + i + 1], table_.fields + 1);
                bool more = false;
                pieces[i] = read_records(records, colors_to_1, std::numeric_limits<std::size_t>::max(), more);
            });
            for (Spheres& piece : pieces) counts += append(scene, std::move(piece));
        }
        return counts;
    }

    // The values of the spheres, `count` of them, that were read.
    FileProperties read_properties_of(std::size_t count) const {
        const auto walk = [&](PropertyTable& properties) {
            CsvRecords records = rows_from(source_, table_, table_.begin);
            const RowReader row(records, table_, options_, false, false);
            glm::dvec3 ignored;
            std::string text;
            while (records.next()) {
                if (!row.read_center(ignored)) continue;
                const auto fields = records.fields();
                properties.add([&](std::size_t place) -> std::string_view {
                    if (place >= fields.size()) return {};
                    if (!fields[place].quoted) return fields[place].text;
                    text = unquoted(fields[place]);
                    return text;
                });
            }
        };
        return read_properties(table_.properties, options_, count, source_.name, walk, table_.decimal_commas);
    }

private:
    Spheres read_records(CsvRecords& records, bool colors_to_1, std::size_t most, bool& more) const {
        Spheres read;
        const RowReader row(records, table_, options_, colors_to_1, names_elements_);
        more = true;
        for (std::size_t i = 0; i < most && more; ++i) {
            more = records.next();
            if (more) row.read(read);
        }
        return read;
    }

    RowCounts append(Scene& scene, Spheres read) const {
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
        return read.counts;
    }

    const TextSource& source_;
    const CsvTable& table_;
    const DataOptions& options_;
    std::vector<std::size_t> places_;  // where pieces of the text begin, and where the last ends
    std::size_t most_ = 0;             // rows
    bool names_elements_ = false;
};

// What to say of a column that is not there.
std::string passed_over_in_words(std::vector<std::string> columns, const DataOptions& options) {
    std::erase_if(columns, [&](const std::string& name) { return is_wanted(options, name, 0); });
    if (columns.empty()) return "";
    constexpr std::size_t most_listed = 20;
    const std::size_t listed_count = std::min(columns.size(), most_listed);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < listed_count; ++i) names.push_back(in_quotes(columns[i]));
    std::string words = joined(names, ", ");
    if (listed_count < columns.size()) {
        words += " and " + in_groups(columns.size() - listed_count) + " more";
    }
    return "columns that are passed over: " + words + "; --color-by and --size-by can use them";
}

}  // namespace

bool shows_csv(std::string_view head) { return is_clearly_csv(is_utf16(head) ? utf8_of_utf16(head) : std::string(head)); }

SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options) {
    const std::string converted = is_utf16(content) ? utf8_of_utf16(content) : "";
    const TextSource source{name, converted.empty() ? without_byte_order_mark(content) : std::string_view(converted)};
    const CsvTable table = find_csv_table(source, options.columns);
    const RowsReader rows(source, table, options);
    SphereData data;
    RowCounts counts = rows.read(data.scene, table.colors_to_1);
    // What the first rows show of the colours need not hold for all of them.
    const bool colors_to_1 = counts.color_fractions && !counts.color_above_1;
    if (colors_to_1 != table.colors_to_1 && table.columns.has(CsvColumn::red)) counts = rows.read(data.scene, colors_to_1);

    add_properties(data, rows.read_properties_of(data.scene.spheres.size()));
    if (!table.has_header && options.columns.empty()) {
        data.warnings.push_back(name + ": no header: the first columns are taken for x, y" +
                                std::string(table.columns.has(CsvColumn::z) ? " and z" : "") +
                                (table.columns.has(CsvColumn::red) ? ", and three more for red, green and blue" : ""));
    }
    if (!table.columns.has(CsvColumn::z)) data.warnings.push_back(name + ": no column for z: all lie in the plane z = 0");
    warn_of_left_out(data, counts.no_center, name, "row", "rows");
    if (counts.radii == 0 && !options.radius && !table.columns.has(CsvColumn::element)) use_radius_of_points(data, name);
    if (const std::string words = passed_over_in_words(table.passed_over, options); !words.empty())
        data.notes.push_back(name + ": " + words);
    return data;
}

}  // namespace sphereview

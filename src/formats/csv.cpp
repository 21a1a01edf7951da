#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

namespace {

constexpr double usual_radius = 1.0;
constexpr const char* open_quote = "found a quote that nothing closes, expected another one behind it";

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

struct CsvField {
    std::string_view text;  // without the blanks around it, or without its quotes: inside the file's text
    bool quoted = false;    // then "" in it stands for one quote
};

// `text` of the field with each "" as one quote.
std::string unquoted(const CsvField& field) {
    std::string text(field.text);
    if (!field.quoted) return text;
    for (std::size_t i = 0; (i = text.find("\"\"", i)) != std::string::npos; ++i) text.erase(i, 1);
    return text;
}

// Reads one record after the other. Blank lines are passed over. A field in quotes may hold anything, line ends too.
class CsvRecords {
public:
    // Reads the records that begin in [begin, end); a record begins at `begin`.
    CsvRecords(const TextSource& source, char separator, char line_end, std::size_t begin, std::size_t end)
        : source_(source), separator_(separator), line_end_(line_end), next_(begin), end_(end) {}

    // False when there is none; the fields are valid until the next call. Throws InputError where quotes are wrong.
    bool next() {
        const char* const first = source_.text.data();
        const char* const last = first + source_.text.size();
        const auto is_separator = [this](char c) { return c == separator_; };
        while (next_ < end_) {
            LineWalker walker(source_.text, line_end_, next_);
            const char* at = first + next_;
            const char* stop = first + walker.step();
            next_ = walker.offset();
            if (std::all_of(at, stop, is_blank)) continue;
            fields_.clear();
            while (true) {
                while (at != stop && is_blank(*at) && !is_separator(*at)) ++at;
                if (at != stop && *at == '"') {
                    at = quoted_field(at);
                    if (at > stop) {  // it went on in another line
                        LineWalker rest(source_.text, line_end_, static_cast<std::size_t>(at - first));
                        stop = at == last ? last : first + rest.step();
                        next_ = at == last ? source_.text.size() : rest.offset();
                    }
                    while (at != stop && is_blank(*at) && !is_separator(*at)) ++at;
                    if (at != stop && !is_separator(*at)) {
                        source_.fail(static_cast<std::size_t>(at - first),
                                     "found " + in_quotes({at, 1}) + " behind a closing quote, expected " +
                                         in_quotes({&separator_, 1}) + " or the end of the line");
                    }
                } else {
                    at = plain_field(at, stop);
                }
                if (at == stop) break;
                ++at;
            }
            record_end_ = stop;
            return true;
        }
        return false;
    }

    const std::vector<CsvField>& fields() const { return fields_; }
    char separator() const { return separator_; }
    // Where the next record or blank line begins.
    std::size_t offset() const { return next_; }

    [[noreturn]] void fail(const CsvField& field, const std::string& expected) const { source_.fail(field.text, expected); }

    // Says that the record ends too early.
    [[noreturn]] void fail_at_end(const std::string& expected) const {
        source_.fail(static_cast<std::size_t>(record_end_ - source_.text.data()), "the line ends, expected " + expected);
    }

private:
    // Reads a field up to `stop`, the end of its line unless it is quoted; returns where it ends.
    const char* quoted_field(const char* begin) {
        const char* const last = source_.text.data() + source_.text.size();
        const char* end = begin;
        do {  // two quotes are one inside
            end = std::find(end + 1, last, '"');
            if (end == last) source_.fail(static_cast<std::size_t>(begin - source_.text.data()), open_quote);
            ++end;
        } while (end != last && *end == '"');
        fields_.push_back({{begin + 1, static_cast<std::size_t>(end - begin) - 2}, true});
        return end;
    }

    const char* plain_field(const char* begin, const char* stop) {
        const void* found = std::memchr(begin, separator_, static_cast<std::size_t>(stop - begin));
        const char* const end = found == nullptr ? stop : static_cast<const char*>(found);
        const char* behind = end;
        while (behind != begin && is_blank(behind[-1])) --behind;
        fields_.push_back({{begin, static_cast<std::size_t>(behind - begin)}, false});
        return end;
    }

    const TextSource& source_;
    char separator_;
    char line_end_;
    std::size_t next_;
    std::size_t end_;
    std::vector<CsvField> fields_{};
    const char* record_end_ = nullptr;
};

enum Column : std::size_t { x, y, z, radius, red, green, blue, name_column, column_count };
constexpr std::array<const char*, column_count> column_names = {"x", "y", "z", "radius", "r", "g", "b", "name"};
constexpr const char* header_syntax = "a header with x, y, z, and perhaps radius, r, g, b, name";

// Which field each column is.
struct Header {
    std::size_t fields = 0;
    std::array<std::optional<std::size_t>, column_count> place{};

    bool has(Column column) const { return place[column].has_value(); }
};

// A field's words as a header has them: "x" for "# X".
std::string header_word(const CsvField& field) {
    const std::string text = lower_case(unquoted(field));
    return std::string(trimmed(std::string_view(text).substr(std::min(text.find_first_not_of("# \t"), text.size())), white_space));
}

// What stands between the fields of the first line.
char separator_of(std::string_view text) {
    bool quoted = false;
    for (const char c : text.substr(std::min(text.find_first_not_of(" \r\n"), text.size()))) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == ',' || c == ';' || c == '\t') return c;
        if (c == '\n' || c == '\r') break;
    }
    return ',';
}

// The header in the record's fields.
Header header_of(const CsvRecords& records) {
    Header header;
    header.fields = records.fields().size();
    for (std::size_t i = 0; i < header.fields; ++i) {
        const CsvField& field = records.fields()[i];
        const auto found = std::ranges::find(column_names, header_word(field));
        if (found == column_names.end()) continue;
        auto& place = header.place[static_cast<std::size_t>(found - column_names.begin())];
        if (place) records.fail(field, "each of x, y, z, radius, r, g, b and name only once");
        place = i;
    }
    if (!header.has(x) || !header.has(y) || !header.has(z)) records.fail(records.fields()[0], header_syntax);
    if (header.has(red) != header.has(green) || header.has(red) != header.has(blue)) {
        records.fail(records.fields()[*header.place[header.has(red)     ? red
                                                    : header.has(green) ? green
                                                                        : blue]],
                     "all three of r, g and b, or none");
    }
    return header;
}

// The spheres of one piece.
struct Spheres {
    std::vector<Sphere> spheres{};
    std::vector<std::pair<std::size_t, std::string>> names{};
};

// Reads the fields of a record.
class RowReader {
public:
    RowReader(const CsvRecords& records, const Header& header, const DataOptions& options)
        : records_(records), header_(header), default_radius_(options.radius.value_or(usual_radius)) {}

    Sphere sphere() const {
        // A separator at the end of the line is common, and no field.
        const std::vector<CsvField>& fields = records_.fields();
        const bool one_empty = fields.size() == header_.fields + 1 && fields.back().text.empty();
        if (fields.size() > header_.fields && !one_empty) {
            records_.fail(fields[header_.fields],
                          "the end of the line after " + std::to_string(header_.fields) + " fields, as the header has them");
        }
        Sphere sphere;
        sphere.center = {number(x), number(y), number(z)};
        sphere.radius = radius_of_row();
        if (header_.has(red) && !(field(red).text.empty() && field(green).text.empty() && field(blue).text.empty())) {
            sphere.color = {channel(red), channel(green), channel(blue)};
        }
        return sphere;
    }

    std::string name() const { return header_.has(name_column) ? as_utf8(unquoted(field(name_column))) : ""; }

private:
    const CsvField& field(Column column) const {
        const std::size_t place = *header_.place[column];
        if (place >= records_.fields().size()) records_.fail_at_end(column_names[column]);
        return records_.fields()[place];
    }

    double number(Column column) const {
        const CsvField& text = field(column);
        double value = 0.0;
        const NumberFault fault = parse_double(text.text, value);
        if (fault == NumberFault::none) return value;
        records_.fail(text, std::string(column_names[column]) + ", " + expected_instead_of(fault));
    }

    double radius_of_row() const {
        if (!header_.has(radius) || field(radius).text.empty()) return default_radius_;
        const double value = number(radius);
        if (!(value > 0.0)) records_.fail(field(radius), "radius above 0");
        return value;
    }

    std::uint8_t channel(Column column) const {
        std::uint8_t value = 0;
        if (parse_whole(field(column).text, value)) return value;
        records_.fail(field(column), column_names[column] + std::string(", a whole number from 0 to 255"));
    }

    const CsvRecords& records_;
    const Header& header_;
    double default_radius_;
};

Spheres read_piece(CsvRecords records, const Header& header, const DataOptions& options) {
    Spheres read;
    const RowReader row(records, header, options);
    while (records.next()) {
        read.spheres.push_back(row.sphere());
        std::string name = row.name();
        if (!name.empty()) read.names.emplace_back(read.spheres.size() - 1, std::move(name));
    }
    return read;
}

// Where pieces of the text from `begin` on begin, each with a record, and where the last ends.
std::vector<std::size_t> piece_places(std::string_view text, std::size_t begin, char line_end) {
    std::vector<std::size_t> places = {begin};
    // Whether a quote opens or closes a field only its line's beginning tells, and that of the line before it.
    const bool in_one = text.find('"', begin) != std::string_view::npos;
    while (!in_one && text.size() - places.back() > usual_line_piece) {
        const std::size_t end = text.find(line_end, places.back() + usual_line_piece);
        if (end == std::string_view::npos) break;
        places.push_back(end + 1);
    }
    places.push_back(text.size());
    return places;
}

Scene joined(std::vector<Spheres> pieces, const std::string& name) {
    Scene scene;
    std::size_t count = 0;
    for (const Spheres& piece : pieces) count += piece.spheres.size();
    if (count > most_spheres)
        throw InputError(name + ": found " + in_groups(count) + " spheres, expected at most " + in_groups(most_spheres));
    require_memory(count * sizeof(Sphere), name + ": " + in_groups(count) + " spheres need");
    if (pieces.size() == 1) {
        scene.spheres = std::move(pieces[0].spheres);
    } else {
        scene.spheres.reserve(count);
    }
    std::size_t first = 0;
    for (Spheres& piece : pieces) {
        if (pieces.size() > 1) scene.spheres.insert(scene.spheres.end(), piece.spheres.begin(), piece.spheres.end());
        for (auto& [index, text] : piece.names) {
            scene.names.emplace_hint(scene.names.end(), static_cast<std::uint32_t>(first + index), std::move(text));
        }
        first = scene.spheres.size();
        piece = {};
    }
    return scene;
}

}  // namespace

bool shows_csv(std::string_view head) {
    head = trimmed(head, white_space);
    const auto names = words_of(take_line(head), "#,;\t \"");
    return std::all_of(column_names.begin(), column_names.begin() + 3, [&](std::string_view axis) {
        return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return lower_case(name) == axis; });
    });
}

SphereData read_csv(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    const char line_end = line_end_of(source.text);
    CsvRecords first(source, separator_of(source.text), line_end, 0, source.text.size());
    if (!first.next()) source.fail(std::size_t{0}, std::string("the text is empty, expected ") + header_syntax);
    const Header header = header_of(first);
    const std::vector<std::size_t> places = piece_places(source.text, first.offset(), line_end);
    std::vector<Spheres> pieces(places.size() - 1);
    parallel_in_order(pieces.size(), [&](std::size_t i) {
        pieces[i] = read_piece({source, first.separator(), line_end, places[i], places[i + 1]}, header, options);
    });
    return {joined(std::move(pieces), name), 1};
}

}  // namespace sphereview

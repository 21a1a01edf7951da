#include "formats/csv_table.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/csv_values.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

constexpr const char* header_syntax = "a header with x, y, z, and perhaps radius, r, g, b, name";
constexpr int most_titles = 100;   // lines before a header
constexpr int most_unit_rows = 3;  // behind it: TrackMate has three

// By which a line may be divided: what stands between fields before what may stand inside of them.
constexpr std::string_view separators = ";\t|, ";

bool is_csv_number(std::string_view text, bool with_commas) {
    double ignored = 0.0;
    return parse_csv_number(text, Commas::none, ignored) == NumberFault::none ||
           (with_commas && (parse_csv_number(text, Commas::decimal, ignored) == NumberFault::none ||
                            parse_csv_number(text, Commas::thousands, ignored) == NumberFault::none));
}

// What rows without a header may begin with, before x, y and z.
bool is_symbol(std::string_view text) { return find_element(text) != nullptr && text[0] >= 'A' && text[0] <= 'Z'; }

// The names in a header. Between blanks a unit in brackets belongs to the name before it.
ColumnNames names_of(const CsvRecords& records, char separator) {
    ColumnNames names;
    for (const CsvField& field : records.fields()) {
        const std::string name = as_utf8(trimmed(unquoted(field), white_space));
        const bool is_unit_of_last =
            separator == ' ' && !names.empty() && (name.starts_with('[') || name.starts_with('(') || name.starts_with('{'));
        if (is_unit_of_last) {
            names.back() += " " + name;
        } else {
            names.push_back(name);
        }
    }
    return names;
}

// What columns without names are called.
ColumnNames numbers_up_to(std::size_t count) {
    ColumnNames numbers;
    for (std::size_t i = 1; i <= count; ++i) numbers.push_back(std::to_string(i));
    return numbers;
}

// Finds where a table begins; see find_csv_table().
class TableFinder {
public:
    TableFinder(const TextSource& source, const std::vector<ColumnChoice>& choices) : source_(source), choices_(choices) {
        table_.layout.line_end = line_end_of(source.text);
    }

    CsvTable find(int titles) {
        std::size_t begin = take_separator_line();
        if (trimmed(source_.text.substr(begin), white_space).empty()) {
            source_.fail(std::size_t{0}, std::string("the text is empty, expected ") + header_syntax);
        }
        std::optional<std::size_t> first_line;
        for (LineWalker lines(source_.text, table_.layout.line_end, begin); !lines.at_end() && titles >= 0;) {
            begin = lines.offset();
            const std::string_view line = trimmed(lines.step(), white_space);
            if (line.empty()) continue;
            if (const std::string_view mark = comment_mark(line); !mark.empty()) {
                look_at_comment(line.substr(mark.size()));
                continue;
            }
            if (!first_line) first_line = begin;
            if (begins_at(begin)) return std::move(table_);
            unknown_header_ = begin;
            --titles;
        }
        if (comment_ && !first_line) return from_comment(comment_->separator, source_.text.size());
        fail(first_line.value_or(begin));
    }

private:
    struct CommentHeader {
        ColumnNames names;
        char separator;
    };

    CsvRecords records(char separator, std::size_t begin) {
        table_.layout.separator = separator;
        return CsvRecords(source_, table_.layout, begin, source_.text.size(), most_csv_columns);
    }

    // Spreadsheets say in a line of its own what divides the others: sep=;
    std::size_t take_separator_line() {
        std::string_view rest = source_.text;
        const std::string_view line = trimmed(take_line(rest), "\" ");
        if (line.size() != 5 || lower_case(line.substr(0, 4)) != "sep=") return 0;
        forced_ = line[4];
        return static_cast<std::size_t>(rest.data() - source_.text.data());
    }

    std::string_view candidates() const { return forced_ ? std::string_view(&*forced_, 1) : separators; }

    // Programs of numbers write the header as a comment: the last one counts.
    void look_at_comment(std::string_view text) {
        const std::size_t begin = source_.offset_of(text);
        const TextSource up_to_end{source_.name, source_.text.substr(0, begin + text.size())};
        for (const char separator : candidates()) {
            table_.layout.separator = separator;
            CsvRecords header(up_to_end, table_.layout, begin, up_to_end.text.size(), most_csv_columns);
            if (!header.try_next() || header.fields().size() < 2 || header.fields().size() > most_csv_columns) continue;
            ColumnNames names = names_of(header, separator);
            const ChosenColumns chosen = choose_columns(names, choices_);
            if (!chosen.has_places() || chosen.places_by_number) continue;
            comment_.emplace(CommentHeader{std::move(names), separator});
            return;
        }
    }

    // Whether the table begins with the line at `begin`: its header, or the first row where there is none, or only a comment.
    bool begins_at(std::size_t begin) { return has_header_at(begin) || (comment_ && fits_comment(begin)) || is_headless(begin); }

    bool has_header_at(std::size_t begin) {
        for (const char separator : candidates()) {
            CsvRecords header = records(separator, begin);
            if (!header.try_next() || header.fields().size() < 2) continue;
            if (header.fields().size() > most_csv_columns) {
                header.fail(header.fields()[most_csv_columns], "at most " + std::to_string(most_csv_columns) + " columns");
            }
            ColumnNames names = names_of(header, separator);
            const ChosenColumns chosen = choose_columns(names, choices_);
            if (!chosen.has_places() || (chosen.places_by_number && !is_row(header, chosen.columns))) continue;
            take(chosen, separator);
            std::size_t first = 0;  // that has a name
            if (chosen.places_by_number) {
                table_.has_header = false;
                table_.begin = begin;
                table_.fields = header.fields().size();
                names = numbers_up_to(table_.fields);
            } else {
                refuse_twice(header, names);
                table_.fields = names.size();
                table_.begin = behind_units(header.offset());
                if (rows_have_names()) first = shift_columns();
                if (separator == ' ' && !fits_rows()) continue;
            }
            look_at_first_rows(source_, names, first, choices_, table_);
            return true;
        }
        return false;
    }

    bool fits_comment(std::size_t begin) {
        for (const char separator : candidates()) {
            CsvRecords row = records(separator, begin);
            if (!row.try_next() || row.fields().size() < 2) continue;
            const std::size_t named = comment_->names.size();
            const bool trails = row.fields().size() == named + 1 && row.fields().back().text.empty();
            if (row.fields().size() != named && !trails) continue;
            from_comment(separator, begin);
            return true;
        }
        return false;
    }

    CsvTable from_comment(char separator, std::size_t begin) {
        take(choose_columns(comment_->names, choices_), separator);
        table_.fields = comment_->names.size();
        table_.begin = begin;
        look_at_first_rows(source_, comment_->names, 0, choices_, table_);
        return table_;
    }

    // Rows of numbers alone, of which the first three are a place; an element may stand before them.
    bool is_headless(std::size_t begin) {
        for (const char separator : candidates()) {
            CsvRecords row = records(separator, begin);
            if (!row.try_next()) continue;
            const auto fields = row.fields();
            const bool trails = fields.size() > 1 && fields.back().text.empty();
            const std::size_t count = fields.size() - (trails ? 1 : 0);
            const auto is_value = [&](const CsvField& field) {
                return is_csv_number(field.text, separator != ',' || field.quoted) ||
                       (!field.text.empty() && is_missing(field.text));
            };
            const std::size_t first = count >= 4 && is_symbol(fields[0].text) ? 1 : 0;
            const auto behind = fields.begin() + static_cast<std::ptrdiff_t>(count);
            if (count < 2 || !std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(first), behind, is_value)) continue;
            // Names that nobody knows are no reason to guess.
            if (unknown_header_) {
                CsvRecords header = records(separator, *unknown_header_);
                if (header.try_next() && header.offset() <= begin && names_of(header, separator).size() == count) continue;
                table_.layout.separator = separator;
            }
            ChosenColumns chosen;
            chosen.columns.places = {first, first + 1, count > 2 ? std::optional<std::size_t>(first + 2) : std::nullopt};
            table_.fields = count;
            if (first > 0) {
                // A sentence may begin like one row.
                if (separator == ' ' && !continues_at(row, count)) continue;
                chosen.columns[CsvColumn::element] = 0;
            } else if (count >= 6 && has_colors_behind_places(begin)) {
                chosen.columns[CsvColumn::red] = 3;
                chosen.columns[CsvColumn::green] = 4;
                chosen.columns[CsvColumn::blue] = 5;
            }
            const ColumnNames numbers = numbers_up_to(count);
            apply_choices(numbers, choices_, chosen);
            if (!chosen.has_places()) continue;
            const CsvColumns& columns = chosen.columns;
            if (!columns.has(CsvColumn::red) || !columns.has(CsvColumn::green) || !columns.has(CsvColumn::blue)) {
                for (const CsvColumn color : {CsvColumn::red, CsvColumn::green, CsvColumn::blue}) chosen.columns[color].reset();
            }
            take(chosen, separator);
            table_.has_header = false;
            table_.begin = begin;
            table_.guessed_places = true;
            look_at_first_rows(source_, numbers, 0, choices_, table_);
            return true;
        }
        return false;
    }

    // Whether another row with an element follows, or nothing.
    static bool continues_at(CsvRecords& rows, std::size_t count) {
        return !rows.try_next() || (rows.fields().size() == count && is_symbol(rows.fields()[0].text));
    }

    // Whether the fourth to sixth column hold nothing but whole numbers from 0 to 255.
    bool has_colors_behind_places(std::size_t begin) {
        CsvRecords rows = rows_from(source_, table_, begin);
        for (std::size_t i = 0; i < csv_rows_looked_at && rows.try_next(); ++i) {
            for (std::size_t k = 3; k < 6; ++k) {
                std::uint8_t ignored = 0;
                if (k >= rows.fields().size() || !parse_whole(rows.fields()[k].text, ignored)) return false;
            }
        }
        return true;
    }

    void take(const ChosenColumns& chosen, char separator) {
        table_.layout.separator = separator;
        table_.columns = chosen.columns;
    }

    // Two columns of one name do not tell which is meant.
    void refuse_twice(const CsvRecords& header, const ColumnNames& names) const {
        const auto fields = header.fields();
        for (const auto& place : table_.columns.places) {
            if (!place || names.size() != fields.size()) continue;
            // A column that is called x, y or z to the letter is meant before others.
            const bool is_exact = names[*place] == "x" || names[*place] == "y" || names[*place] == "z";
            for (std::size_t i = *place + 1; i < names.size(); ++i) {
                const bool is_drawn = std::ranges::find(table_.columns.places, std::optional(i)) != table_.columns.places.end();
                if (is_drawn) continue;  // z beside a Z for atomic numbers
                if (is_exact ? names[i] != names[*place] : lower_case(names[i]) != lower_case(names[*place])) continue;
                header.fail(fields[i], "each of x, y, z, radius, r, g, b and name only once");
            }
        }
    }

    // Where the rows begin: units, or other names, may stand in rows of their own.
    std::size_t behind_units(std::size_t begin) {
        CsvRecords rows = rows_from(source_, table_, begin);
        for (int skipped = 0; skipped <= most_unit_rows && rows.try_next(); ++skipped) {
            if (is_row(rows, table_.columns)) return skipped == 0 ? begin : rows.begin();
            const auto is_word = [](const CsvField& field) { return !is_csv_number(field.text, true); };
            const bool are_units = has_units_for_places(rows);
            if (!std::ranges::all_of(rows.fields(), is_word) && !are_units) break;
            if (are_units) table_.row_of_units = names_of(rows, ',');  // each field is one
        }
        table_.row_of_units.clear();
        return begin;
    }

    bool has_units_for_places(const CsvRecords& rows) const {
        for (const CsvColumn column : {CsvColumn::x, CsvColumn::y}) {
            const std::size_t place = *table_.columns[column];
            if (place >= rows.fields().size() || !is_unit(as_utf8(rows.fields()[place].text))) return false;
        }
        return true;
    }

    // R's write.table names the rows in a column that the header leaves out.
    bool rows_have_names() const {
        CsvRecords rows = rows_from(source_, table_, table_.begin);
        if (!rows.try_next() || rows.fields().size() != table_.fields + 1 || rows.fields().back().text.empty()) return false;
        const CsvField& first = rows.fields()[0];
        return table_.layout.separator == ' ' || first.quoted || !is_csv_number(first.text, true);
    }

    // Behind a field without a name; returns by how many.
    std::size_t shift_columns() {
        for (auto& place : table_.columns.places) {
            if (place) ++*place;
        }
        ++table_.fields;
        return 1;
    }

    // Words between blanks may be a sentence: a header has a row below it, or nothing.
    bool fits_rows() {
        CsvRecords rows = rows_from(source_, table_, table_.begin);
        return !rows.try_next() || (rows.fields().size() == table_.fields && is_row(rows, table_.columns));
    }

    // What is wrong with the columns of --columns in the header that begins there; "" where nothing is known.
    std::string fault_of_choices(std::size_t begin) {
        if (choices_.empty()) return "";
        std::string fault;
        for (const char separator : candidates()) {
            CsvRecords header = records(separator, begin);
            if (!header.try_next() || header.fields().size() < 2) continue;
            const ColumnNames names = names_of(header, separator);
            const ChosenColumns chosen = choose_columns(names, choices_);
            if (chosen.has_places()) return "";
            if (chosen.missing == nullptr) {
                return "found no columns for both x and y, expected --columns x=NAME,y=NAME,z=NAME to name them";
            }
            if (fault.empty()) {
                fault = "found no column " + in_quotes(chosen.missing->field) +
                        ", expected a header with the columns of --columns" + did_you_mean(chosen.missing->field, names);
            }
        }
        return fault;
    }

    [[noreturn]] void fail(std::size_t begin) {
        CsvRecords first = records(forced_.value_or(','), begin);
        if (!first.next()) source_.fail(begin, std::string("the text ends, expected ") + header_syntax);
        if (const std::string message = fault_of_choices(begin); !message.empty()) source_.fail(begin, message);
        const std::string expected = choices_.empty()
                                         ? std::string(header_syntax) + "; --columns x=NAME,y=NAME,z=NAME names others"
                                         : "a header with the columns of --columns, such as " + in_quotes(choices_[0].field);
        if (const std::string columns = columns_in_words(begin); choices_.empty() && !columns.empty()) {
            first.fail_at(first.fields()[0], "found the columns " + columns + ", expected " + expected);
        }
        first.fail(first.fields()[0], expected);
    }

    // The fields of the line that begins there; "" where nothing but blanks divides it: it may be a sentence.
    std::string columns_in_words(std::size_t begin) {
        constexpr std::size_t most_listed = 20;
        for (const char separator : candidates()) {
            CsvRecords header = records(separator, begin);
            if (separator == ' ' || !header.try_next() || header.fields().size() < 2) continue;
            ColumnNames names = names_of(header, separator);
            for (std::string& name : names) name = in_quotes(name);
            return joined(first_of(std::move(names), most_listed), ", ");
        }
        return "";
    }

    const TextSource& source_;
    const std::vector<ColumnChoice>& choices_;
    CsvTable table_{};
    std::optional<char> forced_{};
    std::optional<CommentHeader> comment_{};
    std::optional<std::size_t> unknown_header_{};  // where a line with several fields begins that may be one
};

}  // namespace

bool is_row(const CsvRecords& record, const CsvColumns& columns) {
    const auto is_place = [&](CsvColumn column) {
        const std::size_t place = *columns[column];
        return place < record.fields().size() &&
               (is_missing(record.fields()[place].text) || is_csv_number(record.fields()[place].text, true));
    };
    return is_place(CsvColumn::x) && is_place(CsvColumn::y);
}

CsvTable find_csv_table(const TextSource& source, const std::vector<ColumnChoice>& choices) {
    return TableFinder(source, choices).find(most_titles);
}

bool is_clearly_csv(std::string_view head) {
    try {
        const TextSource source{"", head};
        const CsvTable table = TableFinder(source, {}).find(0);
        if (!table.columns.has(CsvColumn::z)) return false;
        if (table.has_header) return true;
        // Between white space a scene's text may begin with its number of spheres.
        if (table.layout.separator == ',' || table.layout.separator == ';') return true;
        const std::string_view row = trimmed(head.substr(table.begin), white_space);
        return !is_digits(row.substr(0, row.find_first_of(white_space)));
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace sphereview

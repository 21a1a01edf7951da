// The records of a CSV file (RFC 4180), field by field.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formats/text_format.hpp"

namespace sphereview {

struct CsvField {
    std::string_view text;  // without the blanks around it, or without its quotes: inside the file's text
    bool quoted = false;    // then "" in it stands for one quote
};

// `text` of the field with each "" as one quote.
std::string unquoted(const CsvField& field);

// Reads one record after the other. Blank lines are passed over. A field in quotes may hold anything, line ends too.
class CsvRecords {
public:
    // Reads the records that begin in [begin, end); a record begins at `begin`.
    CsvRecords(const TextSource& source, char separator, char line_end, std::size_t begin, std::size_t end)
        : source_(source), separator_(separator), line_end_(line_end), next_(begin), end_(end) {}

    // False when there is none; the fields are valid until the next call. Throws InputError where quotes are wrong.
    bool next();
    const std::vector<CsvField>& fields() const { return fields_; }
    char separator() const { return separator_; }
    // Where the next record or blank line begins.
    std::size_t offset() const { return next_; }

    // "NAME:LINE:COLUMN: " of a place inside the text.
    std::string place(const char* where) const;
    [[noreturn]] void fail(const CsvField& field, const std::string& expected) const;
    // Says that the record ends too early.
    [[noreturn]] void fail_at_end(const std::string& expected) const;

private:
    // Reads a field up to `stop`, the end of its line unless it is quoted; returns where it ends.
    const char* quoted_field(const char* begin);
    const char* plain_field(const char* begin, const char* stop);

    const TextSource& source_;
    char separator_;
    char line_end_;
    std::size_t next_;
    std::size_t end_;
    std::vector<CsvField> fields_{};
    const char* record_end_ = nullptr;
};

}  // namespace sphereview

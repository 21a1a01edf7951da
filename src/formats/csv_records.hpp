// The records of a table in text, one after the other: RFC 4180, and other separators that programs use.
#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

struct CsvField {
    std::string_view text;  // without surrounding blanks or quotes; points into the file's text
    bool quoted = false;    // then "" in it stands for one quote
};

// The field's text, with each "" as one quote.
inline std::string unquoted(const CsvField& field) {
    if (!field.quoted) return std::string(field.text);
    std::string text;
    for (std::string_view rest = field.text; !rest.empty();) {
        const std::size_t quotes = std::min(rest.find("\"\""), rest.size());
        text += rest.substr(0, quotes + 1);
        rest.remove_prefix(std::min(quotes + 2, rest.size()));
    }
    return text;
}

// How the text is divided.
struct CsvLayout {
    char separator = ',';  // a blank: any run of blanks and tabs
    char line_end = '\n';
    bool comments = true;  // lines that begin with #, % or // are left out
};

// The mark of a comment that `line` begins with, behind no blanks; "" for other lines.
inline std::string_view comment_mark(std::string_view line) {
    if (line.empty()) return "";
    if (line[0] == '%' || (line[0] == '#' && !line.starts_with("#N/A"))) return line.substr(0, 1);  // Excel's for a missing number
    return line.starts_with("//") ? line.substr(0, 2) : std::string_view();
}

// Reads one record after the other. Blank lines and comments are passed over. A field in quotes may hold anything, line ends too.
class CsvRecords {
public:
    // Reads the records that begin in [begin, end); a record begins at `begin`. Reads at most `most_fields` + 1 fields of a record:
    // the caller refuses a longer one.
    CsvRecords(const TextSource& source, const CsvLayout& layout, std::size_t begin, std::size_t end, std::size_t most_fields)
        : source_(source),
          layout_(layout),
          in_runs_(layout.separator == ' '),
          begin_(begin),
          next_(begin),
          end_(end),
          most_fields_(most_fields) {}

    // False at the end. The fields are valid until the next call. Throws InputError where quotes are wrong.
    bool next() { return in_runs_ ? next_record<true>() : next_record<false>(); }

    // The same, but false where quotes are wrong: a comment may hold a quote that nothing closes.
    bool try_next() {
        try {
            return next();
        } catch (const InputError&) {
            return false;
        }
    }

    std::span<const CsvField> fields() const { return {fields_.data(), count_}; }
    // Where the line of the last record begins.
    std::size_t begin() const { return begin_; }
    // Where the next record or blank line begins.
    std::size_t offset() const { return next_; }

    [[noreturn]] void fail(const CsvField& field, const std::string& expected) const { source_.fail(field.text, expected); }

    [[noreturn]] void fail_at(const CsvField& field, const std::string& message) const { source_.fail_at(field.text, message); }

    // Says that the record ends too early.
    [[noreturn]] void fail_at_end(const std::string& expected) const {
        source_.fail(static_cast<std::size_t>(record_end_ - source_.text.data()), "the line ends, expected " + expected);
    }

private:
    static constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

    // in_runs: any run of blanks and tabs separates.
    template <bool in_runs>
    bool next_record() {
        const char separator = layout_.separator;
        const auto is_separator = [separator](char c) { return !in_runs && c == separator; };
        const auto behind_blanks = [&](const char* at, const char* stop) {
            while (at != stop && is_blank(*at) && !is_separator(*at)) ++at;
            return at;
        };
        const char* const first = source_.text.data();
        while (next_ < end_) {
            begin_ = next_;
            LineWalker walker(source_.text, layout_.line_end, next_);
            const std::string_view line = walker.step();
            const char* at = line.data();
            const char* stop = at + line.size();
            next_ = walker.offset();
            const char* word = at;
            while (word != stop && is_blank(*word)) ++word;
            if (word == stop) continue;
            const bool may_be_comment = *word == '#' || *word == '%' || *word == '/';
            if (may_be_comment && layout_.comments && !comment_mark({word, static_cast<std::size_t>(stop - word)}).empty())
                continue;
            count_ = 0;
            while (true) {
                at = behind_blanks(at, stop);
                if (at != stop && *at == '"') {
                    at = quoted_field(at);
                    if (at > stop) {  // it went on in another line
                        LineWalker rest(source_.text, layout_.line_end, static_cast<std::size_t>(at - first));
                        stop = rest.at_end() ? at : at + rest.step().size();
                        next_ = rest.offset();
                    }
                    const bool ended = in_runs && at != stop && is_blank(*at);
                    at = behind_blanks(at, stop);
                    if (at != stop && !is_separator(*at) && !ended) fail_behind_quote(at);
                } else {
                    at = plain_field<in_runs>(at, stop);
                    if (in_runs) at = behind_blanks(at, stop);
                }
                if (at == stop || count_ > most_fields_) break;
                if (!in_runs) ++at;
            }
            record_end_ = stop;
            return true;
        }
        return false;
    }

    // Reads a field up to `stop`, the end of its line unless it is quoted; returns where it ends.
    const char* quoted_field(const char* begin) {
        const char* const last = source_.text.data() + source_.text.size();
        const char* end = begin;
        do {  // two quotes are one inside
            end = std::find(end + 1, last, '"');
            if (end == last) {
                source_.fail(static_cast<std::size_t>(begin - source_.text.data()),
                             "found a quote that nothing closes, expected another one behind it");
            }
            ++end;
        } while (end != last && *end == '"');
        put(begin + 1, end - 1, true);
        return end;
    }

    template <bool in_runs>
    const char* plain_field(const char* begin, const char* stop) {
        const char* end = stop;
        if (in_runs) {
            end = std::find_if(begin, stop, is_blank);
        } else if (const void* found = std::memchr(begin, layout_.separator, static_cast<std::size_t>(stop - begin))) {
            end = static_cast<const char*>(found);
        }
        const char* behind = end;
        while (behind != begin && is_blank(behind[-1])) --behind;
        put(begin, behind, false);
        return end;
    }

    // Reuses the room of earlier records' fields: as fast as an array.
    void put(const char* begin, const char* end, bool quoted) {
        if (count_ == fields_.size()) fields_.resize(2 * count_ + 16);
        fields_[count_++] = {{begin, static_cast<std::size_t>(end - begin)}, quoted};
    }

    [[noreturn]] void fail_behind_quote(const char* at) const {
        source_.fail(static_cast<std::size_t>(at - source_.text.data()),
                     "found " + in_quotes({at, 1}) + " behind a closing quote, expected " +
                         (in_runs_ ? "a blank" : in_quotes({&layout_.separator, 1})) + " or the end of the line");
    }

    const TextSource& source_;
    const CsvLayout& layout_;
    bool in_runs_;
    std::size_t begin_;
    std::size_t next_;
    std::size_t end_;
    std::size_t most_fields_;
    std::vector<CsvField> fields_{};  // the record's are the first count_
    std::size_t count_ = 0;
    const char* record_end_ = nullptr;
};

}  // namespace sphereview

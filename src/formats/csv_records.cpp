#include "formats/csv_records.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string unquoted(const CsvField& field) {
    std::string text(field.text);
    if (!field.quoted) return text;
    for (std::size_t i = 0; (i = text.find("\"\"", i)) != std::string::npos; ++i) text.erase(i, 1);
    return text;
}

bool CsvRecords::next() {
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
                    throw InputError(place(at) + "found " + in_quotes({at, 1}) + " behind a closing quote, expected " +
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

const char* CsvRecords::quoted_field(const char* begin) {
    const char* const last = source_.text.data() + source_.text.size();
    const char* end = begin;
    do {  // two quotes are one inside
        end = std::find(end + 1, last, '"');
        if (end == last) throw InputError(place(begin) + "found a quote that nothing closes, expected another one behind it");
        ++end;
    } while (end != last && *end == '"');
    fields_.push_back({{begin + 1, static_cast<std::size_t>(end - begin) - 2}, true});
    return end;
}

const char* CsvRecords::plain_field(const char* begin, const char* stop) {
    const void* found = std::memchr(begin, separator_, static_cast<std::size_t>(stop - begin));
    const char* const end = found == nullptr ? stop : static_cast<const char*>(found);
    const char* behind = end;
    while (behind != begin && is_blank(behind[-1])) --behind;
    fields_.push_back({{begin, static_cast<std::size_t>(behind - begin)}, false});
    return end;
}

std::string CsvRecords::place(const char* where) const {
    return place_in(source_.name, position_at(source_.text, static_cast<std::size_t>(where - source_.text.data()), source_.origin));
}

void CsvRecords::fail(const CsvField& field, const std::string& expected) const {
    throw InputError(place(field.text.data()) + found_expected(field.text, expected));
}

void CsvRecords::fail_at_end(const std::string& expected) const {
    throw InputError(place(record_end_) + "the line ends, expected " + expected);
}

}  // namespace sphereview

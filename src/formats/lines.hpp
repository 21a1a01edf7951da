// Shared by the readers of all formats: texts of lines and words, read on all cores, and the places of faults in them.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "formats/csv_values.hpp"

namespace sphereview {

inline constexpr std::string_view white_space = " \t\n\v\f\r";

// A fault in a text.
struct TextFault : InputError {
    TextFault(const std::string& message, std::size_t place) : InputError(message), offset(place) {}

    std::size_t offset;  // of the fault, from the text's beginning
};

// A text ends where more of it was expected.
struct TextEnds : TextFault {
    using TextFault::TextFault;
};

// A piece of a file, with the file's name in messages and the piece's place in the file.
struct TextSource {
    std::string name;
    std::string_view text;
    TextPosition origin{};

    // "NAME:LINE:COLUMN: " of byte `offset`.
    std::string place(std::size_t offset) const;
    // Of the beginning of a piece of the text.
    std::string place(std::string_view piece) const { return place(offset_of(piece)); }
    std::size_t offset_of(std::string_view piece) const { return static_cast<std::size_t>(piece.data() - text.data()); }
    // Throws TextFault "NAME:LINE:COLUMN: MESSAGE".
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const;
    // Throws TextEnds "NAME:LINE:COLUMN: the text ends, expected EXPECTED".
    [[noreturn]] void fail_at_end(const std::string& expected) const;
    // Throws TextFault "NAME:LINE:COLUMN: found 'PIECE', expected EXPECTED".
    [[noreturn]] void fail(std::string_view piece, const std::string& expected) const;
    // Throws TextFault "NAME:LINE:COLUMN: MESSAGE" with the place where a piece of the text begins.
    [[noreturn]] void fail_at(std::string_view piece, const std::string& message) const;
    // The same with the place where it ends: "the line ends, expected EXPECTED".
    [[noreturn]] void fail_behind(std::string_view line, const std::string& expected) const;
};

// The pieces of a line between runs of separators.
std::vector<std::string_view> words_of(std::string_view line, std::string_view separators = white_space);

// Appends words of a line to `words`, up to `most` in all.
void split_line(std::string_view line, std::size_t most, std::vector<std::string_view>& words);

// Whether a word is a number, by parse_any_double(), or digits alone.
bool is_number(std::string_view word);
bool is_digits(std::string_view word);

// The text of a file without a byte-order mark and marks of the end.
inline std::string_view text_of_file(std::string_view content) { return without_end_marks(without_byte_order_mark(content)); }

// The text behind the last line end; "" if the text ends with one.
std::string_view last_line(std::string_view text);

// Whether the line of byte `offset` is the last one.
bool is_in_last_line(std::string_view text, std::size_t offset);

// The text in columns [begin, end) of a line, from 0, without blanks; "" behind the line's end.
std::string_view in_columns(std::string_view line, std::size_t begin, std::size_t end);

// The text behind a byte-order mark, white space and lines of comment that begin with '#'.
std::string_view behind_comments(std::string_view text);

// `bytes` with U+FFFD for each byte outside a UTF-8 sequence: names must be UTF-8.
std::string as_utf8(std::string_view bytes);

// The bytes of text that a core reads at a time.
inline constexpr std::size_t usual_line_piece = std::size_t{1} << 16;

// The character that ends the lines of a text: LF, or CR if there is no LF.
inline char line_end_of(std::string_view text) {
    return text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos ? '\r' : '\n';
}

// Steps from line to line, as fast as memory.
class LineWalker {
public:
    // `offset`: the beginning of a line.
    LineWalker(std::string_view text, char line_end, std::size_t offset = 0) : text_(text), line_end_(line_end), offset_(offset) {}

    bool at_end() const { return offset_ >= text_.size(); }
    char line_end() const { return line_end_; }
    // Where the next line begins.
    std::size_t offset() const { return offset_; }

    // Steps over a line and returns it without its line end. Not at_end().
    std::string_view step() {
        const std::size_t begin = offset_;
        const void* end = std::memchr(text_.data() + begin, line_end_, text_.size() - begin);
        std::size_t place = text_.size();
        if (end != nullptr) place = static_cast<std::size_t>(static_cast<const char*>(end) - text_.data());
        offset_ = place + (end == nullptr ? 0 : 1);
        if (place > begin && text_[place - 1] == '\r') --place;
        return {text_.data() + begin, place - begin};
    }

private:
    std::string_view text_;
    char line_end_;
    std::size_t offset_;
};

// Without a branch, so that loops over bytes become SIMD.
constexpr bool is_space(char c) { return (c == ' ') | (static_cast<unsigned char>(c - '\t') <= '\r' - '\t'); }

// Reads the numbers of a text, with messages that have the place of a fault. `expected`: a function that describes the expected
// token, called only for a message.
class TokenReader {
public:
    // Reads a number that read_double() does not read whole.
    using Parse = NumberFault (*)(std::string_view token, double& value);

    // Begins at the first token from `offset` on, which must not be inside a token.
    TokenReader(const TextSource& source, std::size_t offset, Parse parse = parse_double)
        : TokenReader(source, source.text.substr(offset), "the text ends", parse) {}
    // Reads one line of the text.
    TokenReader(const TextSource& source, std::string_view line, Parse parse = parse_double)
        : TokenReader(source, line, "the line ends", parse) {}

    bool at_end() const { return next_ == end_; }

    // The offset of the next token, or of the text's end.
    std::size_t offset() const { return static_cast<std::size_t>(next_ - source_.text.data()); }

    // An integer from `low` to `high`.
    template <typename Expected>
    std::int64_t integer(std::int64_t low, std::int64_t high, const Expected& expected) {
        if (at_end()) fail_at_end(end_found_, expected());
        const char* first = next_;
        if (*first == '+' && end_ - first > 1 && first[1] != '-') ++first;
        std::int64_t value = 0;
        const auto result = std::from_chars(first, end_, value);
        if (result.ec == std::errc::invalid_argument || !ends_token(result.ptr)) fail(expected() + ", a whole number");
        if (result.ec != std::errc{} || value < low || value > high) {
            fail(expected() + " from " + std::to_string(low) + " to " + std::to_string(high));
        }
        step_to(result.ptr);
        return value;
    }

    // A finite number.
    template <typename Expected>
    double number(const Expected& expected) {
        const NextNumber next = next_finite_number(expected);
        step_to(next.end);
        return next.value;
    }

    template <typename Expected>
    double positive_number(const Expected& expected) {
        const NextNumber next = next_finite_number(expected);
        if (!(next.value > 0.0)) fail(expected() + " above 0");
        step_to(next.end);
        return next.value;
    }

    // A number for decoration only: `instead` for a missing number (stands_for_none()), or for one beyond a double.
    template <typename Expected>
    double number_or(double instead, const Expected& expected) {
        const NextNumber next = next_number(expected);
        const bool is_any = next.fault == NumberFault::none;
        if (!is_any && next.fault != NumberFault::too_large && !stands_for_none(token(), next.fault)) {
            fail(expected() + ", " + expected_instead_of(next.fault));
        }
        step_to(next.end);
        return is_any ? next.value : instead;
    }

    // A finite number; false, with 0 in `value`, for a missing number (stands_for_none()).
    template <typename Expected>
    bool number_if_any(const Expected& expected, double& value) {
        const NextNumber next = next_number(expected);
        const bool is_any = next.fault == NumberFault::none;
        value = next.value;
        if (!is_any) {
            if (!stands_for_none(token(), next.fault)) fail(expected() + ", " + expected_instead_of(next.fault));
            value = 0.0;
        }
        step_to(next.end);
        return is_any;
    }

    // The next token, whatever it is.
    template <typename Expected>
    std::string_view word(const Expected& expected) {
        if (at_end()) fail_at_end(end_found_, expected());
        const std::string_view next = token();
        step_to(next.data() + next.size());
        return next;
    }

    // The unread text.
    std::string_view rest() const { return {next_, static_cast<std::size_t>(end_ - next_)}; }

    // The next token; "" at the end.
    std::string_view token() const { return {next_, static_cast<std::size_t>(std::find_if(next_, end_, is_space) - next_)}; }

    void skip_tokens(std::size_t count) {
        for (; count > 0; --count) step_to(token().data() + token().size());
    }

    // Says that the next token is wrong.
    [[noreturn]] void fail(const std::string& expected) const { source_.fail(token(), expected); }

    [[noreturn]] void fail_at_end(const std::string& found, const std::string& expected) const {
        source_.fail_at({end_, 0}, found + ", expected " + expected);
    }

private:
    // end_found: the end in messages.
    TokenReader(const TextSource& source, std::string_view text, const char* end_found, Parse parse)
        : source_(source), next_(text.data()), end_(text.data() + text.size()), end_found_(end_found), parse_(parse) {
        skip_space();
    }

    // The next token as a number; `value` is undefined with a fault.
    struct NextNumber {
        double value = 0.0;
        const char* end = nullptr;
        NumberFault fault = NumberFault::none;
    };

    template <typename Expected>
    NextNumber next_number(const Expected& expected) const {
        if (at_end()) fail_at_end(end_found_, expected());
        NextNumber next;
        const auto result = read_double(next_, end_, next.value);
        next.end = result.ptr;
        if (result.ec != std::errc{} || !ends_token(next.end) || !std::isfinite(next.value)) {
            next.end = next_ + token().size();
            next.fault = parse_(token(), next.value);
        }
        return next;
    }

    template <typename Expected>
    NextNumber next_finite_number(const Expected& expected) const {
        const NextNumber next = next_number(expected);
        if (next.fault != NumberFault::none) fail(expected() + ", " + expected_instead_of(next.fault));
        return next;
    }

    bool ends_token(const char* place) const { return place == end_ || is_space(*place); }

    void step_to(const char* place) {
        next_ = place;
        skip_space();
    }

    void skip_space() {
        while (next_ != end_ && is_space(*next_)) ++next_;
    }

    const TextSource& source_;
    const char* next_;
    const char* end_;
    const char* end_found_;
    Parse parse_;
};

// Calls work(i) for each i below `count`, on all cores. Throws the exception of the lowest i.
template <typename Work>
void parallel_in_order(std::size_t count, const Work& work) {
    std::vector<std::exception_ptr> faults(count);
    parallel_for(count, [&](std::size_t i) {
        try {
            work(i);
        } catch (...) {
            faults[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& fault : faults) {
        if (fault) std::rethrow_exception(fault);
    }
}

}  // namespace sphereview

// Walks through the numbers of a text, and says where it stands when one is wrong.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/number.hpp"
#include "formats/lines.hpp"

namespace sphereview {

// Without a branch, so that loops over bytes become SIMD.
constexpr bool is_space(char c) { return (c == ' ') | (static_cast<unsigned char>(c - '\t') <= '\r' - '\t'); }

// `expected`, here, is a function that describes what should stand there: its words are only made for a message.
class TokenReader {
public:
    // Begins at the first token at or after `offset`, which lies between two tokens. `end_found`: how messages call the end.
    TokenReader(const TextSource& source, std::size_t offset, const char* end_found = "the text ends")
        : source_(source),
          next_(source.text.data() + offset),
          end_(source.text.data() + source.text.size()),
          end_found_(end_found) {
        skip_space();
    }

    bool at_end() const { return next_ == end_; }

    // Of the next token, or of the text's end.
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
        const auto is_good = [](double) { return true; };
        return number(expected, is_good, "");
    }

    template <typename Expected>
    double positive_number(const Expected& expected) {
        const auto is_good = [](double value) { return value > 0.0; };
        return number(expected, is_good, " above 0");
    }

    // A finite number that `is_good`, which `what_is_good` says in words: " above 0".
    template <typename Expected, typename IsGood>
    double number(const Expected& expected, const IsGood& is_good, const char* what_is_good) {
        if (at_end()) fail_at_end(end_found_, expected());
        double value = 0.0;
        const auto result = read_double(next_, end_, value);
        const char* last = result.ptr;
        if (result.ec != std::errc{} || !ends_token(last) || !std::isfinite(value)) {
            last = next_ + token().size();
            const NumberFault fault = parse_double(token(), value);
            if (fault != NumberFault::none) fail(expected() + ", " + expected_instead_of(fault));
        }
        if (!is_good(value)) fail(expected() + what_is_good);
        step_to(last);
        return value;
    }

    // The next token; "" at the end.
    std::string_view token() const { return {next_, static_cast<std::size_t>(std::find_if(next_, end_, is_space) - next_)}; }

    void skip_tokens(std::size_t count) {
        for (; count > 0; --count) step_to(token().data() + token().size());
    }

    // Says that the next token is wrong.
    [[noreturn]] void fail(const std::string& expected) const { source_.fail(token(), expected); }

    [[noreturn]] void fail_at_end(const std::string& found, const std::string& expected) const {
        source_.fail(source_.text.size(), found + ", expected " + expected);
    }

private:
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
};

}  // namespace sphereview

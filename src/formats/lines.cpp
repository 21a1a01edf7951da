#include "formats/lines.hpp"

namespace sphereview {

std::string TextSource::place(std::size_t offset) const { return place_in(name, position_at(text, offset, origin)); }

void TextSource::fail(std::size_t offset, const std::string& message) const { throw TextFault(place(offset) + message, offset); }

void TextSource::fail_at_end(const std::string& expected) const {
    throw TextEnds(place(text.size()) + "the text ends, expected " + expected, text.size());
}

void TextSource::fail(std::string_view piece, const std::string& expected) const {
    fail_at(piece, found_expected(piece, expected));
}

void TextSource::fail_at(std::string_view piece, const std::string& message) const { fail(offset_of(piece), message); }

void TextSource::fail_behind(std::string_view line, const std::string& expected) const {
    fail_at(line.substr(line.size()), "the line ends, expected " + expected);
}

void split_line(std::string_view line, std::size_t most, std::vector<std::string_view>& words) {
    const char* const end = line.data() + line.size();
    for (const char* at = line.data(); words.size() < most;) {
        at = std::find_if_not(at, end, is_space);
        if (at == end) return;
        const char* const word = at;
        at = std::find_if(at, end, is_space);
        words.emplace_back(word, static_cast<std::size_t>(at - word));
    }
}

std::vector<std::string_view> words_of(std::string_view line, std::string_view separators) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; (begin = line.find_first_not_of(separators, begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

bool is_number(std::string_view word) {
    double ignored = 0.0;
    return parse_any_double(word, ignored) == NumberFault::none;
}

bool is_digits(std::string_view word) { return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos; }

std::string_view last_line(std::string_view text) { return text.substr(text.find_last_of("\r\n") + 1); }

bool is_in_last_line(std::string_view text, std::size_t offset) {
    const std::size_t end = text.find(line_end_of(text), offset);
    return end == std::string_view::npos || text.find_first_not_of(white_space, end) == std::string_view::npos;
}

std::string_view in_columns(std::string_view line, std::size_t begin, std::size_t end) {
    return line.size() <= begin ? "" : trimmed(line.substr(begin, end - begin), " ");
}

std::string_view behind_comments(std::string_view text) {
    text = trimmed(without_byte_order_mark(text), white_space);
    while (text.starts_with('#')) {
        take_line(text);
        text = trimmed(text, white_space);
    }
    return text;
}

std::string as_utf8(std::string_view bytes) {
    constexpr std::string_view replacement = "\xEF\xBF\xBD";
    std::string text;
    text.reserve(bytes.size());
    while (!bytes.empty()) {
        const std::size_t length = first_character(bytes).length;
        text += length == 0 ? replacement : bytes.substr(0, length);
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text;
}

}  // namespace sphereview

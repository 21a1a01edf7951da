#include "formats/lines.hpp"

#include "base/error.hpp"

namespace sphereview {

namespace {

// How many bytes the UTF-8 sequence has that begins `bytes` (RFC 3629); 0 if none does.
std::size_t sequence_length(std::string_view bytes) {
    const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U; };
    const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
        return byte(i) >= low && byte(i) <= high;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
    // No longer forms of shorter sequences, no surrogates, nothing beyond U+10FFFF.
    if (first >= 0xE0 && first <= 0xEF) {
        return follows(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF) && follows(2) ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        return follows(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF) && follows(2) && follows(3) ? 4 : 0;
    }
    return 0;
}

}  // namespace

std::string TextSource::place(std::size_t offset) const { return place_in(name, position_at(text, offset, origin)); }

void TextSource::fail(std::size_t offset, const std::string& message) const { throw InputError(place(offset) + message); }

void TextSource::fail(std::string_view piece, const std::string& expected) const {
    throw InputError(place(piece) + found_expected(piece, expected));
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
        const std::size_t length = sequence_length(bytes);
        text += length == 0 ? replacement : bytes.substr(0, length);
        bytes.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text;
}

}  // namespace sphereview

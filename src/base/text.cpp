#include "base/text.hpp"

#include <algorithm>
#include <array>

namespace sphereview {

TextPosition position_at(std::string_view text, std::size_t offset, TextPosition origin) {
    offset = std::min(offset, text.size());
    if (offset == 0) return origin;
    const auto ends_line = [&](std::size_t i) {
        return text[i] == '\n' || (text[i] == '\r' && (i + 1 == text.size() || text[i + 1] != '\n'));
    };
    const auto ends_line_before_another = [bytes = text.data()](std::size_t i) {
        return (bytes[i] == '\n') | ((bytes[i] == '\r') & (bytes[i + 1] != '\n'));
    };
    const auto begins_character = [bytes = text.data()](std::size_t i) {
        return (bytes[i] & 0xC0) != 0x80;  // not the continuation of a UTF-8 sequence
    };
    const std::size_t line_ends = count_places(0, offset - 1, ends_line_before_another) + (ends_line(offset - 1) ? 1 : 0);
    std::size_t line_begin = offset;
    while (line_begin > 0 && !ends_line(line_begin - 1)) --line_begin;
    const std::size_t characters = count_places(line_begin, offset, begins_character);
    return {origin.line + line_ends, (line_begin == 0 ? origin.column : 1) + characters};
}

std::string place_in(std::string_view name, TextPosition position) {
    return std::string(name) + ":" + std::to_string(position.line) + ":" + std::to_string(position.column) + ": ";
}

std::string found_expected(std::string_view found, std::string_view expected) {
    return "found " + in_quotes(found) + ", expected " + std::string(expected);
}

namespace {

// "\xNN"
void append_in_digits(std::string& text, char character) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(character);
    text += "\\x";
    text += digits[byte >> 4];
    text += digits[byte & 15];
}

}  // namespace

Utf8Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return {1, first};
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) return {};
    char32_t code = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    if (overlong || surrogate || code > 0x10FFFF) return {};
    return {length, code};
}

namespace {

// Whether it steers a terminal, ends a line or turns the order of others around (Unicode's bidirectional marks).
bool is_control(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E || code == 0x200F ||
           (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string printable(std::string_view text, std::size_t most, bool keep_lines) {
    std::string safe;
    for (; !text.empty() && most > 0; --most) {
        const Utf8Character next = first_character(text);
        const std::string_view bytes = text.substr(0, std::max<std::size_t>(next.length, 1));
        if (next.length > 0 && (!is_control(next.code) || (keep_lines && next.code == '\n'))) {
            safe += bytes;
        } else {
            for (const char byte : bytes) append_in_digits(safe, byte);
        }
        text.remove_prefix(bytes.size());
    }
    return text.empty() ? safe : safe + "...";
}

}  // namespace

std::string on_one_line(std::string_view text, std::size_t most) { return printable(text, most, false); }
std::string on_lines(std::string_view text, std::size_t most) { return printable(text, most, true); }

std::string in_quotes(std::string_view found) {
    constexpr std::size_t longest = 40;
    std::string text = "'";
    for (const char character : found) {
        if (text.size() > longest) {
            text += "...";
            break;
        }
        if (character >= ' ' && character <= '~') {
            text += character;
        } else {
            append_in_digits(text, character);
        }
    }
    return text + "'";
}

namespace {

struct Accent {
    char32_t code;
    std::string_view letters;  // each without the accent, then with it
};

constexpr std::array<Accent, 13> accents = {{
    {0x300, "AÀEÈIÌOÒUÙaàeèiìoòuù"},
    {0x301, "AÁEÉIÍOÓUÚYÝaáeéiíoóuúyýCĆcćLĹlĺNŃnńRŔrŕSŚsśZŹzź"},
    {0x302, "AÂEÊIÎOÔUÛaâeêiîoôuûCĈcĉGĜgĝHĤhĥJĴjĵSŜsŝWŴwŵYŶyŷ"},
    {0x303, "AÃNÑOÕaãnñoõIĨiĩUŨuũ"},
    {0x304, "AĀaāEĒeēIĪiīOŌoōUŪuū"},
    {0x306, "AĂaăEĔeĕGĞgğIĬiĭOŎoŏUŬuŭ"},
    {0x307, "CĊcċEĖeėGĠgġIİZŻzż"},
    {0x308, "AÄEËIÏOÖUÜaäeëiïoöuüyÿYŸ"},
    {0x30A, "AÅaåUŮuů"},
    {0x30B, "OŐoőUŰuű"},
    {0x30C, "CČcčDĎdďEĚeěNŇnňRŘrřSŠsšTŤtťZŽzž"},
    {0x327, "CÇcçGĢKĶkķLĻlļNŅnņRŖrŗSŞsşTŢtţ"},
    {0x328, "AĄaąEĘeęIĮiįUŲuų"},
}};

// The letter with the accent; "" where there is none.
std::string_view accented(std::string_view letter, char32_t code) {
    const auto accent = std::ranges::find(accents, code, &Accent::code);
    if (accent == accents.end() || letter.size() != 1) return "";
    const std::size_t place = accent->letters.find(letter);
    if (place == std::string_view::npos) return "";
    const std::string_view with = accent->letters.substr(place + 1);
    return with.substr(0, first_character(with).length);
}

}  // namespace

std::string composed(std::string_view text) {
    std::string result;
    std::size_t last = 0;  // where the last character begins
    while (!text.empty()) {
        const Utf8Character next = first_character(text);
        const std::size_t length = std::max<std::size_t>(next.length, 1);
        const std::string_view whole = accented(std::string_view(result).substr(last), next.length > 0 ? next.code : 0);
        if (whole.empty()) {
            last = result.size();
            result += text.substr(0, length);
        } else {
            result.replace(last, std::string::npos, whole);
        }
        text.remove_prefix(length);
    }
    return result;
}

std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
    return line;
}

std::string_view trimmed(std::string_view text, std::string_view white) {
    const std::size_t begin = text.find_first_not_of(white);
    if (begin == std::string_view::npos) return "";
    return text.substr(begin, text.find_last_not_of(white) + 1 - begin);
}

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

namespace {

// Whether each second byte from `zero` on is 0 and the others are what texts of Latin letters hold, as far as it is looked at.
bool is_latin_in_pairs(std::string_view bytes, std::size_t zero) {
    constexpr std::size_t enough = 64;
    const std::string_view head = bytes.substr(0, std::min(enough, bytes.size() / 2 * 2));
    for (std::size_t i = 0; i < head.size(); i += 2) {
        const char letter = head[i + 1 - zero];
        const bool is_text =
            static_cast<unsigned char>(letter) >= ' ' || letter == '\n' || letter == '\r' || letter == '\t' || letter == '\x1A';
        if (head[i + zero] != '\0' || !is_text) return false;
    }
    return head.size() > 2;
}

constexpr char16_t replacement = 0xFFFD;
constexpr char32_t first_of_pairs = 0x10000;

bool is_first_half(char32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_second_half(char32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

char byte_of(char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); }

// Also of a half of a pair.
void append_as_utf8(std::string& text, char32_t code) {
    if (code < 0x80) {
        text += byte_of(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < first_of_pairs ? 2 : 3;  // bytes behind the first
    constexpr char32_t marks[] = {0, 0xC0, 0xE0, 0xF0};
    text += byte_of(marks[more] | code >> (6 * more));
    for (int i = more - 1; i >= 0; --i) text += byte_of(0x80 | (code >> (6 * i) & 0x3F));
}

// The half of a pair that `text` begins with, as append_as_utf8() writes it; 0 where it begins otherwise.
char16_t first_lone_half(std::string_view text) {
    if (text.size() < 3 || text[0] != '\xED') return 0;
    const auto second = static_cast<unsigned char>(text[1]);
    const auto third = static_cast<unsigned char>(text[2]);
    const bool good = second >= 0xA0 && second < 0xC0 && third >= 0x80 && third < 0xC0;
    return good ? static_cast<char16_t>(0xD000 | (second & 0x3F) << 6 | (third & 0x3F)) : char16_t{0};
}

bool has_utf16_mark(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

}  // namespace

bool is_utf16(std::string_view bytes) {
    return has_utf16_mark(bytes) || is_latin_in_pairs(bytes, 0) || is_latin_in_pairs(bytes, 1);
}

std::string_view without_end_marks(std::string_view text) {
    using namespace std::string_view_literals;
    return is_utf16(text) ? text : text.substr(0, text.find_last_not_of("\0\x1A"sv) + 1);
}

std::string utf8_from(std::u16string_view units) {
    std::string text;
    text.reserve(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        char32_t code = units[i];
        if (is_first_half(code) && i + 1 < units.size() && is_second_half(units[i + 1])) {
            code = first_of_pairs + ((code & 0x3FF) << 10 | (units[++i] & 0x3FFU));
        }
        append_as_utf8(text, code);
    }
    return text;
}

std::u16string utf16_from(std::string_view text) {
    std::u16string units;
    units.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character next = first_character(text);
        const char16_t half = first_lone_half(text);
        if (next.length == 0) {
            units += half != 0 ? half : replacement;
        } else if (next.code < first_of_pairs) {
            units += static_cast<char16_t>(next.code);
        } else {
            units += static_cast<char16_t>(0xD800 | (next.code - first_of_pairs) >> 10);
            units += static_cast<char16_t>(0xDC00 | (next.code & 0x3FF));
        }
        text.remove_prefix(next.length > 0 ? next.length : half != 0 ? 3 : 1);
    }
    return units;
}

std::string utf8_of_utf16(std::string_view bytes) {
    const bool has_mark = has_utf16_mark(bytes);
    const bool low_first = has_mark ? bytes[0] == '\xFF' : bytes.size() > 1 && bytes[1] == '\0';
    if (has_mark) bytes.remove_prefix(2);
    const std::size_t low = low_first ? 0 : 1;  // which of two bytes is the lower one
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    std::u16string units;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) units += static_cast<char16_t>(byte(i + low) | byte(i + 1 - low) << 8);
    const auto is_half = [&](std::size_t i, char16_t first) {
        return i < units.size() && units[i] >= first && units[i] < first + 0x400;
    };
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (is_half(i, 0xD800) && is_half(i + 1, 0xDC00)) {
            ++i;
        } else if (is_half(i, 0xD800) || is_half(i, 0xDC00)) {
            units[i] = 0xFFFD;
        }
    }
    return utf8_from(units);
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& character : lower) {
        if (character >= 'A' && character <= 'Z') character = static_cast<char>(character - 'A' + 'a');
    }
    return lower;
}

bool has_ending(std::string_view name, std::string_view ending) { return lower_case(name).ends_with(lower_case(ending)); }

namespace {

// Levenshtein's distance: the fewest insertions, deletions and substitutions of one character.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

std::string sorted_letters(std::string word) {
    std::ranges::sort(word);
    return word;
}

// The only candidate that begins with the word; "" where there are none or several.
std::string begun_by(const std::string& word, std::span<const std::string> candidates) {
    constexpr std::size_t fewest_letters = 3;
    if (word.size() < fewest_letters) return "";
    const auto begins = [&](const std::string& candidate) { return lower_case(candidate).starts_with(word); };
    if (std::ranges::count_if(candidates, begins) != 1) return "";
    return *std::ranges::find_if(candidates, begins);
}

}  // namespace

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    if (word.empty() || word.size() > 64) return "";
    const std::string typed = lower_case(word);
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.find_first_of("0123456789") == 0) continue;  // of numbers every one is like another
        std::size_t distance = edit_distance(typed, lower_case(candidate));
        if (distance >= word.size()) continue;  // every letter is another
        if (distance > 1 && sorted_letters(typed) == sorted_letters(lower_case(candidate))) distance = 1;  // a slip of two fingers
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    if (best.empty()) best = begun_by(typed, candidates);
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

std::string joined(std::span<const std::string> words, std::string_view between) {
    std::string text;
    for (const std::string& word : words) text += std::string(&word == words.data() ? "" : between) + word;
    return text;
}

std::string listed(std::span<const std::string> words, std::string_view last) {
    if (words.size() < 2) return joined(words, "");
    return joined(words.first(words.size() - 1), ", ") + " " + std::string(last) + " " + words.back();
}

std::vector<std::string> first_of(std::vector<std::string> words, std::size_t most) {
    if (words.size() <= most) return words;
    const std::size_t more = words.size() - most;
    words.resize(most);
    words.push_back(in_groups(more) + " more");
    return words;
}

std::vector<std::string> words_listed(std::string_view list) {
    std::vector<std::string> words;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(", "), list.size());
        const std::size_t last = std::min(list.find(" or "), list.size());
        const std::string_view part = list.substr(0, std::min(comma, last));
        const bool is_word = part.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789") == std::string_view::npos;
        if (is_word && !part.empty()) words.emplace_back(part);
        list.remove_prefix(std::min(part.size() + (comma < last ? 2 : 4), list.size()));
    }
    return words;
}

std::string in_groups(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, ",");
    return text;
}

std::string counted(std::uint64_t count, std::string_view what) {
    return in_groups(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace sphereview

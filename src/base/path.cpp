#include "base/path.hpp"

#include <cstddef>

#include "base/text.hpp"

namespace sphereview {

namespace {

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

}  // namespace

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

bool is_network_name([[maybe_unused]] const std::filesystem::path& path) {
#ifdef _WIN32
    const std::wstring& name = path.native();
    const auto is_slash = [](wchar_t unit) { return unit == L'\\' || unit == L'/'; };
    return name.size() > 2 && is_slash(name[0]) && is_slash(name[1]) && !is_slash(name[2]);
#else
    return false;
#endif
}

std::filesystem::path normal_path(const std::filesystem::path& path) {
    std::filesystem::path normal = path.lexically_normal();
#ifdef _WIN32
    if (is_network_name(path) && !is_network_name(normal)) normal = L"\\" + normal.native();
#endif
    return normal;
}

}  // namespace sphereview

#include "base/nesting.hpp"

#include <algorithm>

namespace sphereview {

namespace {

// The offset behind the string that begins with the quote at `begin`.
std::size_t behind_string(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const bool of_lines = text.substr(begin, 3) == std::string_view(quote == '"' ? R"(""")" : "'''");
    std::size_t i = begin + (of_lines ? 3 : 1);
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (text[i] == quote) {
            if (!of_lines) return i + 1;
            const std::size_t run = std::min(text.find_first_not_of(quote, i), text.size()) - i;
            if (run >= 3) return i + std::min<std::size_t>(run, 5);  // up to two quotes of the string's own stand before its end
            i += run - 1;
        } else if (text[i] == '\n' && !of_lines) {
            return i;  // no string: a fault
        }
    }
    return text.size();
}

// The offset from `begin` on where visit(offset, how many brackets are open behind it) is true first, or else the text's size. What
// stands in strings and comments is not visited.
template <typename Visit>
std::size_t find_place(std::string_view text, std::size_t begin, const Visit& visit) {
    int brackets = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
            case '\'': i = behind_string(text, i) - 1; continue;
            case '#': i = std::min(text.find('\n', i), text.size()) - 1; continue;
            case '[':
            case '{': ++brackets; break;
            case ']':
            case '}': brackets = std::max(brackets - 1, 0); break;
            default: break;
        }
        if (visit(i, brackets)) return i;
    }
    return text.size();
}

bool ends_key(char c) { return c == '\n' || c == '=' || c == ',' || c == ':' || c == '[' || c == ']' || c == '{' || c == '}'; }

// The offset of the line's end behind the statement at `begin`, or behind the key of a table's head.
std::size_t behind_statement(std::string_view text, std::size_t begin) {
    return find_place(text, begin, [&](std::size_t i, int brackets) { return text[i] == '\n' && brackets == 0; });
}

}  // namespace

std::optional<TooDeep> find_too_deep(std::string_view text) {
    int dots = 0;  // in what may be one key
    const std::size_t place = find_place(text, 0, [&](std::size_t i, int brackets) {
        if (text[i] == '.') return ++dots >= most_nested;
        if (ends_key(text[i])) dots = 0;
        return brackets > most_nested;
    });
    return place < text.size() ? std::optional(TooDeep{place, text[place] == '.'}) : std::nullopt;
}

std::optional<KeyInText> find_unknown_key(std::string_view text, std::span<const std::string> known) {
    constexpr std::string_view bare = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    bool in_table = false;  // whose keys are no business of the top level
    for (std::size_t i = 0; (i = text.find_first_not_of(" \t\r\n", i)) < text.size(); i = behind_statement(text, i)) {
        if (text[i] == '#') continue;
        const bool is_head = text[i] == '[';
        if (in_table && !is_head) continue;
        in_table = is_head;
        if (is_head) i = std::min(text.find_first_not_of("[ \t", i), text.size());
        const bool quoted = i < text.size() && (text[i] == '"' || text[i] == '\'');
        const std::size_t end = quoted ? behind_string(text, i) : std::min(text.find_first_not_of(bare, i), text.size());
        const std::size_t next = text.find_first_not_of(" \t", end);
        if (end == i || next >= text.size() || (text[next] != '.' && text[next] != (is_head ? ']' : '='))) return std::nullopt;
        const std::string_view key = quoted ? text.substr(i + 1, end - i - 2) : text.substr(i, end - i);
        const bool has_escape = quoted && text[i] == '"' && key.find('\\') != std::string_view::npos;
        if (!has_escape && std::find(known.begin(), known.end(), key) == known.end()) return KeyInText{i, key};
    }
    return std::nullopt;
}

bool has_comment(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '#') return true;
        if (text[i] == '"' || text[i] == '\'') i = behind_string(text, i) - 1;
    }
    return false;
}

}  // namespace sphereview

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

// The offset behind the string or comment at `begin`.
std::size_t behind_string_or_comment(std::string_view text, std::size_t begin) {
    return text[begin] == '#' ? std::min(text.find('\n', begin), text.size()) : behind_string(text, begin);
}

}  // namespace

std::optional<TooDeep> find_too_deep(std::string_view text) {
    int brackets = 0;
    int dots = 0;  // in what may be one key
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
            case '\'':
            case '#': i = behind_string_or_comment(text, i) - 1; break;
            case '.':
                if (++dots >= most_nested) return TooDeep{i, true};
                break;
            case '[':
            case '{':
                dots = 0;
                if (++brackets > most_nested) return TooDeep{i, false};
                break;
            case ']':
            case '}':
                dots = 0;
                brackets = std::max(brackets - 1, 0);
                break;
            case '=':
            case ',':
            case ':':
            case '\n': dots = 0; break;
            default: break;
        }
    }
    return std::nullopt;
}

namespace {

// The offset of the line's end behind the statement at `begin`, or behind the key of a table's head.
std::size_t behind_statement(std::string_view text, std::size_t begin) {
    int brackets = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
            case '\'':
            case '#': i = behind_string_or_comment(text, i) - 1; break;
            case '[':
            case '{': ++brackets; break;
            case ']':
            case '}': brackets = std::max(brackets - 1, 0); break;
            case '\n':
                if (brackets == 0) return i;
                break;
            default: break;
        }
    }
    return text.size();
}

}  // namespace

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

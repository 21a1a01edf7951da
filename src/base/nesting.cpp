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

}  // namespace

std::optional<TooDeep> find_too_deep(std::string_view text) {
    int brackets = 0;
    int dots = 0;  // in what may be one key
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '"':
            case '\'': i = behind_string(text, i) - 1; break;
            case '#': i = std::min(text.find('\n', i), text.size()) - 1; break;
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

bool has_comment(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '#') return true;
        if (text[i] == '"' || text[i] == '\'') i = behind_string(text, i) - 1;
    }
    return false;
}

}  // namespace sphereview

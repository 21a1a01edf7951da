#include "formats/sphere_data.hpp"

#include <algorithm>

namespace sphereview {

namespace {

constexpr std::string_view blanks = " \t";

std::string_view without_blanks(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of(blanks), text.size()));
}

// What stands behind `spheres =` on a line that begins so; else nothing.
std::string_view behind_key(std::string_view line) {
    constexpr std::string_view key = "spheres";
    line = without_blanks(line);
    if (!line.starts_with(key)) return {};
    line = without_blanks(line.substr(key.size()));
    return line.starts_with('=') ? without_blanks(line.substr(1)) : std::string_view{};
}

// Only what numbers are written with, and lines that end as TOML has it: then each byte stands for itself.
bool is_plain(std::string_view text) {
    const bool numbers = std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || c == ' ' || c == '\n' || c == '.' || c == '-' || c == '\r' || c == '\t' || c == '+' ||
               c == 'e' || c == 'E';
    });
    for (std::size_t i = 0; numbers && (i = text.find('\r', i)) != std::string_view::npos; ++i) {
        if (i + 1 == text.size() || text[i + 1] != '\n') return false;
    }
    return numbers;
}

}  // namespace

std::optional<SpheresLiteral> find_spheres_literal(std::string_view content) {
    for (std::size_t begin = 0; begin < content.size();) {
        const std::size_t end = std::min(content.find('\n', begin), content.size());
        const std::string_view line = content.substr(begin, end - begin);
        const std::string_view value = behind_key(line);
        const std::string_view quotes = value.substr(0, 3);
        if (quotes == "\"\"\"" || quotes == "'''") {
            const std::size_t first = static_cast<std::size_t>(value.data() - content.data()) + 3;
            const std::size_t last = content.find(quotes, first);
            if (last == std::string_view::npos) return std::nullopt;
            if (content.substr(last + 3).starts_with(quotes[0])) return std::nullopt;  // a quote of the string's own ends it
            std::string_view text = content.substr(first, last - first);
            if (!is_plain(text)) return std::nullopt;
            std::string rest(content.substr(0, first));
            const std::size_t last_line = text.rfind('\n') + 1;  // 0 when there is one line only
            rest.append(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), '\n');
            rest += content.substr(first + last_line);
            if (text.starts_with("\r\n")) text.remove_prefix(1);
            if (text.starts_with('\n')) text.remove_prefix(1);
            return SpheresLiteral{text, std::move(rest)};
        }
        const bool table = without_blanks(line).starts_with('[');
        if (table || line.find("\"\"\"") != std::string_view::npos || line.find("'''") != std::string_view::npos)
            return std::nullopt;
        begin = end + 1;
    }
    return std::nullopt;
}

}  // namespace sphereview

#include "formats/sphere_data.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace sphereview {

namespace {

constexpr std::string_view blanks = " \t";

// What stands behind `KEY =` on a line that begins so; else nothing.
std::string_view behind_key(std::string_view line, std::string_view key) {
    line = trimmed(line, blanks);
    if (!line.starts_with(key)) return {};
    line = trimmed(line.substr(key.size()), blanks);
    return line.starts_with('=') ? trimmed(line.substr(1), blanks) : std::string_view{};
}

// Only what numbers, and nan, are written with, and lines that end as TOML has it: then each byte stands for itself.
bool is_plain(std::string_view text) {
    const bool numbers = std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= '0' && c <= '9') || c == ' ' || c == '\n' || c == '.' || c == '-' || c == '\r' || c == '\t' || c == '+' ||
               c == 'e' || c == 'E' || c == 'n' || c == 'a';
    });
    for (std::size_t i = 0; numbers && (i = text.find('\r', i)) != std::string_view::npos; ++i) {
        if (i + 1 == text.size() || text[i + 1] != '\n') return false;
    }
    return numbers;
}

}  // namespace

std::optional<NumberLiterals> find_number_literals(std::string_view content) {
    NumberLiterals found;
    std::size_t copied = 0;  // of the content, to `rest`
    std::size_t line_number = 1;
    bool in_table = false;
    for (std::size_t begin = 0; begin < content.size(); ++line_number) {
        const std::size_t end = std::min(content.find('\n', begin), content.size());
        const std::string_view line = content.substr(begin, end - begin);
        const std::string_view spheres = in_table ? std::string_view() : behind_key(line, "spheres");
        const std::string_view value = spheres.empty() ? behind_key(line, "values") : spheres;
        const std::string_view quotes = value.substr(0, 3);
        begin = end + 1;
        if (quotes == "\"\"\"" || quotes == "'''") {
            const std::size_t first = static_cast<std::size_t>(value.data() - content.data()) + 3;
            const std::size_t last = content.find(quotes, first);
            if (last == std::string_view::npos) break;
            if (content.substr(last + 3).starts_with(quotes[0])) break;  // a quote of the string's own ends it
            std::string_view text = content.substr(first, last - first);
            if (!is_plain(text)) break;
            const std::size_t last_line = text.rfind('\n') + 1;  // 0 when there is one line only
            const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
            found.rest.append(content.substr(copied, first - copied)).append(lines, '\n');
            copied = first + last_line;
            begin = std::min(content.find('\n', last), content.size()) + 1;
            if (text.starts_with("\r\n")) text.remove_prefix(1);
            if (text.starts_with('\n')) text.remove_prefix(1);
            found.literals.push_back({line_number, text});
            line_number += lines;
            // Behind the quotes there may be a comment, which may look like anything.
            continue;
        }
        in_table = in_table || trimmed(line, blanks).starts_with('[');
        if (line.find("\"\"\"") != std::string_view::npos || line.find("'''") != std::string_view::npos) break;
    }
    if (found.literals.empty()) return std::nullopt;
    found.rest += content.substr(copied);
    return found;
}

}  // namespace sphereview

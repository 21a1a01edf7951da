#include "formats/sphere_tables.hpp"

#include "base/text.hpp"
#include "formats/lines.hpp"

namespace sphereview {

namespace {

bool is_head(std::string_view line) {
    constexpr std::string_view head = "[[sphere]]";
    if (!line.starts_with(head)) return false;
    const std::string_view behind = trimmed(line.substr(head.size()));
    return behind.empty() || behind.starts_with('#');
}

}  // namespace

std::optional<SphereTables> find_sphere_tables(std::string_view content, std::size_t piece) {
    for (const char* quotes : {"\"\"\"", "'''"}) {
        if (content.find(quotes) != std::string_view::npos) return std::nullopt;
    }
    SphereTables found;
    bool among_spheres = false;
    std::size_t begun = 0;  // the piece, or what belongs to the rest
    const auto end_at = [&](std::size_t offset) {
        const std::string_view text = content.substr(begun, offset - begun);
        if (among_spheres) {
            found.pieces.push_back(text);
        } else {
            found.rest += text;
        }
        begun = offset;
    };
    for (LineWalker lines(content, '\n'); !lines.at_end();) {
        const std::size_t begin = lines.offset();
        const std::string_view line = trimmed(lines.step());
        const bool head = is_head(line);
        if (head) ++found.count;
        if (line.starts_with("name") || line.starts_with("\"name\"")) ++found.names;
        const bool turns = line.starts_with('[') && head != among_spheres;
        if (turns || (head && begin - begun >= piece)) end_at(begin);
        if (turns) among_spheres = head;
    }
    end_at(content.size());
    if (found.count == 0) return std::nullopt;
    return found;
}

}  // namespace sphereview

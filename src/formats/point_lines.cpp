#include "formats/point_lines.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atoms.hpp"
#include "formats/lines.hpp"
#include "formats/point_radius.hpp"

namespace sphereview {

namespace {

bool is_comment(std::string_view line) { return line.starts_with('#') || line.starts_with("//"); }

}  // namespace

bool is_bare_points(std::string_view text) {
    constexpr int lines_looked_at = 3;
    std::size_t words_a_line = 0;
    for (int line = 0; line < lines_looked_at;) {
        text = trimmed(text, white_space);
        if (text.empty()) break;
        const std::string_view next = take_line(text);
        if (is_comment(next)) continue;
        const auto words = words_of(next);
        if (words.size() < 3 || !std::all_of(words.begin(), words.begin() + 3, is_number)) return false;
        if (line > 0 && words.size() != words_a_line) return false;
        words_a_line = words.size();
        ++line;
    }
    return words_a_line > 0;
}

SphereData read_points(std::string_view text, const std::string& name, const DataOptions& options) {
    require_frame(name, options.frame, 1);
    const TextSource source{name, text};
    const char line_end = line_end_of(source.text);
    const auto count = static_cast<std::size_t>(std::ranges::count(source.text, line_end)) + 1;
    require_memory_for_spheres(name, count);
    SphereData data;
    std::vector<Sphere>& spheres = data.scene.spheres;
    spheres.reserve(count);
    for (LineWalker walker(source.text, line_end); !walker.at_end();) {
        TokenReader reader(source, walker.step(), parse_any_double);
        if (reader.at_end() || is_comment(reader.token())) continue;
        const auto of_point = [&](const char* what) { return [&spheres, what] { return what + std::to_string(spheres.size()); }; };
        Sphere sphere{.radius = options.radius.value_or(1.0), .color = {color_max, color_max, color_max}};
        sphere.center.x = reader.number(of_point("the x of point "));
        sphere.center.y = reader.number(of_point("the y of point "));
        sphere.center.z = reader.number(of_point("the z of point "));
        spheres.push_back(sphere);
    }
    if (!options.radius) use_radius_of_points(data, name);
    return data;
}

}  // namespace sphereview

#include "formats/scene_format.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/toml_format.hpp"

namespace sphereview {

namespace {

constexpr const char* white_space = " \t\r\n\v\f";

std::string_view skip_white_space(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(white_space);
    return begin == std::string_view::npos ? std::string_view{} : text.substr(begin);
}

// The content from its first character that is neither white space nor a byte-order mark.
std::string_view first_words(std::string_view content) { return skip_white_space(without_byte_order_mark(content)); }

// The same, behind any lines of comment.
std::string_view first_words_behind_comments(std::string_view content) {
    std::string_view words = first_words(content);
    while (words.starts_with('#')) {
        const std::size_t end = words.find_first_of("\r\n");
        words = end == std::string_view::npos ? std::string_view{} : skip_white_space(words.substr(end));
    }
    return words;
}

bool starts_a_toml_line(std::string_view words) {
    if (words.starts_with('[')) return true;
    // A key of letters, digits, '_', '-', '.' or quotes, then '='.
    const std::string_view line = words.substr(0, words.find_first_of("\r\n"));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return false;
    return std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(equals), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view(" \t_-.'\"").find(c) != std::string_view::npos;
    });
}

// Of a text scene that begins with one.
[[noreturn]] void refuse_comment(std::string_view content, std::string_view name) {
    content = without_byte_order_mark(content);
    throw InputError(place_in(name, position_at(content, content.find('#'))) +
                     "found a comment, expected the number of spheres: only TOML has comments, the text format has none");
}

// What separates the words of a line in a data file.
std::vector<std::string_view> words_of(std::string_view line, const char* separators) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; (begin = line.find_first_not_of(separators, begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_number(std::string_view word) {
    double ignored = 0.0;
    return parse_double(word, ignored) == NumberFault::none;
}

bool is_whole_number(std::string_view word) { return word.find_first_not_of("0123456789") == std::string_view::npos; }

// A number, a comment, and an element before a position. A text scene has its colours and centres there.
bool shows_xyz(std::string_view words) {
    const auto count = words_of(take_line(words), white_space);
    const std::string_view comment_line = take_line(words);
    const auto comment = words_of(comment_line, white_space);
    const auto atom = words_of(take_line(words), white_space);
    if (count.size() != 1 || !is_whole_number(count[0]) || atom.empty()) return false;
    if (comment.size() == 3 && std::ranges::all_of(comment, is_whole_number)) return false;
    if (lower_case(comment_line).find("properties=") != std::string::npos || is_letter(atom[0][0])) return true;
    return atom.size() > 3 && is_whole_number(atom[0]) && !comment.empty() && !is_number(comment[0]);
}

bool shows_csv(std::string_view words) {
    const auto names = words_of(take_line(words), "#,;\t \"");
    return std::ranges::all_of(std::array{"x", "y", "z"}, [&](const char* axis) {
        return std::ranges::any_of(names, [&](std::string_view name) { return lower_case(name) == axis; });
    });
}

bool shows_pdb(std::string_view words) {
    const auto records = {"HEADER", "TITLE", "COMPND", "REMARK", "CRYST1", "MODEL", "ATOM", "HETATM"};
    const auto first = words_of(take_line(words), white_space);
    return first.size() > 1 && std::ranges::find(records, first[0]) != records.end() && !first[1].starts_with('=');
}

std::optional<SceneFormat> data_shown_by(std::string_view content) {
    content = content.substr(0, std::size_t{1} << 16);
    std::string_view words = first_words(content);
    if (shows_xyz(words)) return SceneFormat::xyz;
    if (shows_csv(words)) return SceneFormat::csv;
    if (shows_pdb(words)) return SceneFormat::pdb;
    words = first_words_behind_comments(content);
    if (words.starts_with("data_") && take_line(words).find('=') == std::string_view::npos) return SceneFormat::mmcif;
    return std::nullopt;
}

}  // namespace

std::string_view words_for(SceneFormat format) {
    switch (format) {
        case SceneFormat::text: return "the text format";
        case SceneFormat::toml: return "TOML";
        case SceneFormat::xyz: return "XYZ";
        case SceneFormat::csv: return "CSV";
        case SceneFormat::pdb: return "PDB";
        case SceneFormat::mmcif: return "mmCIF";
    }
    return "";
}

SceneFormat format_of_name(std::string_view path) {
    const std::string whole = lower_case(path);
    std::string_view name = whole;
    if (name.ends_with(".gz")) name.remove_suffix(3);
    const auto ends_with = [&](std::initializer_list<const char*> endings) {
        return std::ranges::any_of(endings, [&](const char* ending) { return name.ends_with(ending); });
    };
    if (ends_with({".toml"})) return SceneFormat::toml;
    if (ends_with({".xyz", ".extxyz"})) return SceneFormat::xyz;
    if (ends_with({".csv"})) return SceneFormat::csv;
    if (ends_with({".pdb", ".ent"})) return SceneFormat::pdb;
    if (ends_with({".cif", ".mmcif"})) return SceneFormat::mmcif;
    return SceneFormat::text;
}

SceneFormat detect_format(std::string_view content, std::string_view name) {
    const SceneFormat named = format_of_name(name);
    if (is_data(named)) return named;
    const std::string lower = lower_case(name);
    const bool says_text = lower.ends_with(".txt") || lower.ends_with(".txt.gz");
    if (named == SceneFormat::text && !says_text) {
        if (const auto data = data_shown_by(content)) return *data;
    }
    const bool comment = first_words(content).starts_with('#');
    const std::string_view words = first_words_behind_comments(content);
    if (starts_a_toml_line(words) || (comment && words.empty())) return SceneFormat::toml;
    const bool number = !words.empty() && std::string_view("0123456789+-.").find(words[0]) != std::string_view::npos;
    const SceneFormat format = number ? SceneFormat::text : named;
    if (format == SceneFormat::text && comment) refuse_comment(content, name);
    return format;
}

Scene parse_scene(std::string_view content, const std::string& name) {
    if (detect_format(content, name) == SceneFormat::toml) return parse_toml(content, name);
    Scene scene;
    scene.spheres = parse_text_spheres({name, content});
    return scene;
}

std::string write_scene(const Scene& scene, SceneFormat format) {
    return format == SceneFormat::toml ? write_toml(scene) : write_text_spheres(scene.spheres);
}

std::string lost_in(const Scene& scene, SceneFormat format) {
    if (format == SceneFormat::toml) return "";
    std::string lost;
    const auto add = [&](const std::string& what) { lost += (lost.empty() ? "" : ", ") + what; };
    if (scene.background != Background{}) add("the background");
    if (scene.camera != Camera{}) add("the camera");
    if (!scene.names.empty()) add("the names (" + std::to_string(scene.names.size()) + ")");
    const auto hidden = std::count_if(scene.spheres.begin(), scene.spheres.end(), [](const Sphere& s) { return s.hidden; });
    if (hidden != 0) add("the hidden spheres (" + std::to_string(hidden) + ")");
    return lost;
}

}  // namespace sphereview

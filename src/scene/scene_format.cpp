#include "scene/scene_format.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/toml_format.hpp"

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
    const TextPosition place = position_at(content, content.find('#'));
    throw InputError(std::string(name) + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) +
                     ": found a comment, expected the number of spheres: only TOML has comments, the text format has none");
}

}  // namespace

SceneFormat format_of_name(std::string_view path) {
    return lower_case(path).ends_with(".toml") ? SceneFormat::toml : SceneFormat::text;
}

SceneFormat detect_format(std::string_view content, std::string_view name) {
    const bool comment = first_words(content).starts_with('#');
    const std::string_view words = first_words_behind_comments(content);
    if (starts_a_toml_line(words) || (comment && words.empty())) return SceneFormat::toml;
    const bool number = !words.empty() && std::string_view("0123456789+-.").find(words[0]) != std::string_view::npos;
    const SceneFormat format = number ? SceneFormat::text : format_of_name(name);
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

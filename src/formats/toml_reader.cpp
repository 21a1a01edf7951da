#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/nesting.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"
#include "formats/sphere_tables.hpp"
#include "formats/text_format.hpp"
#include "formats/toml_values.hpp"

namespace sphereview {

namespace {

// The next sphere of the scene.
void read_sphere(const TomlText& document, const toml::table& table, Scene& scene) {
    static const std::vector<std::string> keys = {"name", "color", "center", "radius", "hidden"};
    const std::size_t index = scene.spheres.size();
    const TableReader reader(document, table, "[[sphere]] " + std::to_string(index + 1), keys);
    Sphere sphere;
    sphere.center = reader.vector(reader.require("center"), "center");
    const toml::node& radius = reader.require("radius");
    sphere.radius = reader.number(radius, "'radius' as a finite number above 0");
    if (!(sphere.radius > 0.0)) wrong(document, radius, "'radius' above 0");
    sphere.color = reader.color(reader.require("color"));
    if (const auto* hidden = reader.find("hidden")) sphere.hidden = reader.value<bool>(*hidden, "'hidden' as true or false");
    if (const auto* name = reader.find("name")) {
        const auto text = reader.value<std::string>(*name, "'name' as a string");
        if (!text.empty()) scene.names[static_cast<std::uint32_t>(index)] = text;
    }
    scene.spheres.push_back(sphere);
}

// Reads [camera] or a [[view]].
Camera read_camera(const TomlText& document, const toml::table& table, const TableReader& reader) {
    Camera camera;
    if (const auto* node = reader.find("eye")) camera.eye = reader.vector(*node, "eye");
    if (const auto* node = reader.find("center")) camera.center = reader.vector(*node, "center");
    if (const auto* node = reader.find("right")) camera.right = reader.vector(*node, "right");
    if (const auto* node = reader.find("up")) camera.up = reader.vector(*node, "up");
    if (const auto* node = reader.find("projection")) {
        const std::string expected = R"('projection' as "perspective" or "orthographic")";
        const auto projection = projection_named(reader.value<std::string>(*node, expected));
        if (!projection) wrong(document, *node, expected);
        camera.projection = *projection;
    }
    if (const auto fault = camera_fault(camera)) {
        const toml::node* culprit = &table;
        for (auto key = fault->vectors.rbegin(); key != fault->vectors.rend(); ++key) {
            if (const auto* given = reader.find(*key)) culprit = given;
        }
        fail(document, *culprit,
             "found a camera that cannot be used: " + fault->what +
                 "; expected perpendicular, equally long 'right' and 'up' (within 1e-6) and an eye off the screen's plane");
    }
    return camera;
}

Camera read_camera(const TomlText& document, const toml::table& table) {
    static const std::vector<std::string> keys = {"eye", "center", "right", "up", "projection"};
    return read_camera(document, table, TableReader(document, table, "[camera]", keys));
}

std::vector<SavedView> read_views(const TomlText& document, const toml::node& node) {
    static const std::vector<std::string> keys = {"name", "eye", "center", "right", "up", "projection"};
    std::vector<SavedView> views;
    std::set<std::string> names;
    for (const toml::table* table : tables_in(document, node, "view")) {
        const TableReader reader(document, *table, "[[view]] " + std::to_string(views.size() + 1), keys);
        const toml::node& name = reader.require("name");
        SavedView view{reader.value<std::string>(name, "'name' as a string"), {}};
        if (const std::string fault = view_name_fault(view.name); !fault.empty())
            fail(document, name, "found " + in_quotes(view.name) + ", " + fault + ", expected a name of its own for the view");
        if (!names.insert(view.name).second)
            fail(document, name, "found " + in_quotes(view.name) + " again, expected each name once");
        view.camera = read_camera(document, *table, reader);
        views.push_back(std::move(view));
    }
    return views;
}

Light read_light(const TomlText& document, const toml::table& table) {
    static const std::vector<std::string> keys = {"lights", "sky", "key", "sun", "sun_strength"};
    const TableReader reader(document, table, "[light]", keys);
    Light light;
    if (const auto* node = reader.find("lights")) {
        const std::string expected =
            "'lights' as a whole number from " + std::to_string(fewest_lights) + " to " + std::to_string(most_lights);
        const auto lights = reader.value<std::int64_t>(*node, expected);
        if (lights < fewest_lights || lights > most_lights) wrong(document, *node, expected);
        light.lights = static_cast<int>(lights);
    }
    const auto part = [&](const char* key, double most) -> std::optional<double> {
        const auto* node = reader.find(key);
        if (node == nullptr) return std::nullopt;
        const std::string expected = std::string("'") + key + "' as a number from 0 to " + shortest(most);
        const double found = reader.number(*node, expected);
        if (!(found >= 0.0 && found <= most)) wrong(document, *node, expected);
        return found;
    };
    light.sky = part("sky", most_sky);
    light.key = part("key", most_key).value_or(light.key);
    if (const auto* node = reader.find("sun")) {
        const glm::dvec3 direction = reader.vector(*node, "sun");
        if (direction == glm::dvec3(0.0)) fail(document, *node, "found a sun in no direction, expected 'sun' other than [0, 0, 0]");
        light.sun = Sun{direction};
    }
    if (const auto* node = reader.find("sun_strength")) {
        const std::string expected = "'sun_strength' as a number from " + shortest(weakest_sun) + " to " + shortest(strongest_sun);
        const double strength = reader.number(*node, expected);
        if (!(strength >= weakest_sun && strength <= strongest_sun)) wrong(document, *node, expected);
        if (!light.sun) fail(document, *node, "found 'sun_strength' without 'sun', expected 'sun = [x, y, z]' as well");
        light.sun->strength = strength;
    }
    return light;
}

// The sphere whose number stands there.
std::uint32_t sphere_number(const TomlText& document, const toml::source_position& place, std::string_view text,
                            const Scene& scene) {
    std::uint64_t number = 0;
    const bool whole = parse_whole(text, number) && (text.size() == 1 || text[0] != '0');
    if (whole && number < scene.spheres.size()) return static_cast<std::uint32_t>(number);
    fail(document, place,
         found_expected(text, "the number of one of " + std::to_string(scene.spheres.size()) + " spheres, from 0"));
}

// What is said of single spheres of the text: [names] and `hidden`.
void read_exceptions(const TomlText& document, const TableReader& reader, Scene& scene) {
    if (const toml::node* node = reader.find("names")) {
        if (!node->is_table()) wrong(document, *node, "the table [names]");
        for (const auto& [key, value] : *node->as_table()) {
            const std::uint32_t number = sphere_number(document, key.source().begin, key.str(), scene);
            const auto name = reader.value<std::string>(value, "a name as a string");
            if (!name.empty()) scene.names[number] = name;
        }
    }
    if (const toml::node* node = reader.find("hidden")) {
        const toml::array* array = node->as_array();
        if (array == nullptr) wrong(document, *node, "'hidden' as an array of the numbers of spheres");
        for (const toml::node& value : *array) {
            if (!value.is_integer()) wrong(document, value, "the number of a sphere");
            Sphere& sphere = scene.spheres[sphere_number(document, value.source().begin, found(value), scene)];
            if (sphere.hidden) fail(document, value, "found " + found(value) + " again, expected each number once");
            sphere.hidden = true;
        }
    }
}

void read_spheres(const TomlText& document, const TableReader& reader, Scene& scene) {
    const toml::node* tables = reader.find("sphere");
    const toml::node* text = reader.find("spheres");
    if (tables != nullptr && text != nullptr) {
        fail(document, *text, "found both 'spheres' and [[sphere]], expected only one of them");
    }
    if (text != nullptr) {
        const auto* value = text->as_string();
        if (value == nullptr) wrong(document, *text, "'spheres' as a string in the text format");
        scene.spheres = parse_text_spheres(inside_string(document, *value));
        return read_exceptions(document, reader, scene);
    }
    for (const char* key : {"names", "hidden"}) {
        if (const toml::node* node = reader.find(key)) {
            fail(document, *node,
                 "found " + in_quotes(key) + " without 'spheres', expected 'spheres', or " +
                     (key[0] == 'n' ? "'name'" : "'hidden'") + " in each [[sphere]]");
        }
    }
    if (tables != nullptr) {
        for (const toml::table* table : tables_in(document, *tables, "sphere")) read_sphere(document, *table, scene);
    }
}

// What toml++ makes of a text, at most: a node for each value in an array, a table for each part of a key and for each bracket, and
// copies of the strings. Measured: 72 bytes a number of an array, 88 and 120 an empty array or table in it, 170 a key of one part
// and 230 each part of a dotted one.
std::uint64_t bytes_of_tree(std::string_view text) {
    constexpr std::uint64_t bytes_of_value = 80;
    constexpr std::uint64_t bytes_of_bracket = 70;
    constexpr std::uint64_t bytes_of_key_part = 260;
    std::uint64_t values = 0;
    std::uint64_t brackets = 0;
    std::uint64_t key_parts = 0;
    std::uint64_t dots = 0;  // in what may be one key
    for (const char c : text) {
        if (c == '.') ++dots;
        if (c == '=' || c == ']') key_parts += dots + (c == '=' ? 1 : 0);
        if (c == ',') ++values;
        if (c == '[' || c == '{') ++brackets;
        if (c == ',' || c == '=' || c == '[' || c == '{' || c == ']' || c == '\n') dots = 0;
    }
    return 3 * std::uint64_t{text.size()} + values * bytes_of_value + brackets * bytes_of_bracket + key_parts * bytes_of_key_part;
}

// The name of the top level in messages.
constexpr const char* top_level = "the scene";
const std::vector<std::string>& top_keys() {
    static const std::vector<std::string> keys = {"background", "camera",  "light",  "view", "property",
                                                  "sphere",     "spheres", "hidden", "names"};
    return keys;
}

toml::table parse(const TomlText& document) {
    if (const auto deep = find_too_deep(document.content)) {
        const std::string most = std::to_string(most_nested);
        TextSource{document.name, document.content}.fail(
            deep->offset, deep->in_key ? "found a key of more than " + most + " parts, expected at most " + most
                                       : "found values nested more than " + most + " deep, expected at most " + most);
    }
    // A large tree, which may take 100 times the text, is not made in vain.
    constexpr std::uint64_t large = std::uint64_t{1} << 25;
    const std::uint64_t bytes = bytes_of_tree(document.content);
    if (const auto unknown = bytes > large ? find_unknown_key(document.content, top_keys()) : std::nullopt) {
        TextSource{document.name, document.content}.fail(unknown->offset, unknown_key(unknown->key, top_level, top_keys()));
    }
    require_memory(bytes, document.name + ": its values need");
    try {
        return toml::parse(document.content);  // without the name, whose copy it makes where nothing may be thrown
    } catch (const toml::parse_error& error) {
        std::string description;
        for (const char c : error.description()) description += c >= ' ' && c <= '~' ? c : '?';
        toml::source_position place = error.source().begin;
        // A number that is too large is met behind its end.
        if (description.ends_with("representable in 64 bits") || description.ends_with("interpreted as a value")) {
            const std::string_view before = document.content.substr(0, offset_of(document, place));
            const std::size_t begin = before.find_last_not_of("+-._0123456789abcdefABCDEFx") + 1;
            place.column -= std::min(place.column, static_cast<toml::source_index>(before.size() - begin));
        }
        fail(document, place, "this is not TOML: " + description);
    }
}

// Reads what the scene holds beside `scene`, which has the spheres unless they stand in `table`.
SphereData read_scene(const TomlText& document, const toml::table& table, Scene scene) {
    const TableReader reader(document, table, top_level, top_keys());
    if (const auto* node = reader.find("background")) {
        const std::string expected = "'background' as a string: " + std::string(background_syntax);
        if (!parse_background(reader.value<std::string>(*node, expected), scene.background)) wrong(document, *node, expected);
    }
    if (const auto* node = reader.find("camera")) {
        if (!node->is_table()) wrong(document, *node, "the table [camera]");
        scene.camera = read_camera(document, *node->as_table());
    }
    if (const auto* node = reader.find("light")) {
        if (!node->is_table()) wrong(document, *node, "the table [light]");
        scene.light = read_light(document, *node->as_table());
    }
    if (const auto* node = reader.find("view")) scene.views = read_views(document, *node);
    if (scene.spheres.empty()) read_spheres(document, reader, scene);
    if (const auto* node = reader.find("property")) scene.properties = read_properties(document, *node, scene.spheres.size());
    SphereData data{std::move(scene)};
    for (const Property& property : data.scene.properties) data.property_names.push_back(property.name);
    return data;
}

// Reads a piece of a document that has only [[sphere]] tables.
Scene read_sphere_tables(const TomlText& piece) {
    const toml::table table = parse(piece);
    Scene scene;
    read_spheres(piece, TableReader(piece, table, top_level, top_keys()), scene);
    return scene;
}

constexpr std::size_t bytes_a_piece = std::size_t{1} << 15;

// The spheres of all tables, some pieces at a time, on all cores.
Scene read_sphere_tables(const std::string& name, const SphereTables& tables) {
    constexpr std::size_t pieces_at_once = 32;
    constexpr std::size_t bytes_of_pieces = 20 * pieces_at_once * bytes_a_piece;
    constexpr std::size_t bytes_of_name = 112;  // an entry of a map; longer words beside it
    require_memory(tables.count * sizeof(Sphere) + tables.names * bytes_of_name + bytes_of_pieces,
                   name + ": " + in_groups(tables.count) + " spheres need");
    Scene all;
    all.spheres.reserve(tables.count);
    std::vector<Scene> scenes;
    for (std::size_t first = 0; first < tables.pieces.size(); first += pieces_at_once) {
        scenes.assign(std::min(pieces_at_once, tables.pieces.size() - first), Scene{});
        parallel_in_order(scenes.size(), [&](std::size_t i) {
            scenes[i] = read_sphere_tables(TomlText{name, tables.pieces[first + i]});
        });
        for (Scene& scene : scenes) {
            const auto before = static_cast<std::uint32_t>(all.spheres.size());
            all.spheres.insert(all.spheres.end(), scene.spheres.begin(), scene.spheres.end());
            for (auto& [number, sphere_name] : scene.names) {
                all.names.emplace_hint(all.names.end(), before + number, std::move(sphere_name));
            }
        }
    }
    return all;
}

// Reads a scene of many [[sphere]] tables without a tree of them all. Nothing where there are few, or where anything is wrong or
// odd: the whole tree tells where.
std::optional<SphereData> read_in_pieces(const TomlText& document) {
    constexpr std::size_t many = std::size_t{1} << 20;
    if (document.content.size() < many) return std::nullopt;
    const auto tables = find_sphere_tables(document.content, bytes_a_piece);
    if (!tables) return std::nullopt;
    try {
        const TomlText rest{document.name, tables->rest};
        const toml::table table = parse(rest);
        for (const char* key : {"sphere", "spheres", "names", "hidden"}) {
            if (table.contains(key)) return std::nullopt;
        }
        return read_scene(rest, table, read_sphere_tables(document.name, *tables));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace

SphereData read_toml(std::string_view content, const std::string& name, const DataOptions&) {
    content = text_of_file(content);
    const auto literals = find_number_literals(content);
    if (literals) content = literals->rest;
    const TomlText document{name, content, literals ? literals->literals : std::vector<NumberLiteral>()};
    if (content.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        fail(document, {1, 1}, "the file is empty, expected a scene in TOML");
    }
    if (auto read = read_in_pieces(document)) return std::move(*read);
    return read_scene(document, parse(document), {});
}

// A table's head, `key =`, or nothing but comments.
bool shows_toml(std::string_view head) {
    std::string_view words = behind_comments(head);
    if (words.empty()) return !trimmed(head, white_space).empty();
    if (words.starts_with('[')) return true;
    const std::string_view line = take_line(words);
    const std::string_view key = line.substr(0, std::min(line.find('='), line.size()));
    return key.size() < line.size() && std::all_of(key.begin(), key.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      std::string_view(" \t_-.'\"").find(c) != std::string_view::npos;
           });
}

}  // namespace sphereview

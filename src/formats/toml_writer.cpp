#include <array>
#include <cmath>
#include <cstdio>
#include <type_traits>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/sphere_data.hpp"
#include "formats/text_format.hpp"

namespace sphereview {

namespace {

// A TOML float: shortest()'s digits with a point or an exponent, because -0 as a TOML integer would lose its sign.
void append_float(std::string& text, double value) {
    const std::size_t begin = text.size();
    text += shortest(value);
    if (text.find_first_of(".e", begin) == std::string::npos) text += ".0";
}

void append_vector(std::string& text, std::string_view key, const glm::dvec3& v) {
    text.append(key) += " = [";
    append_float(text, v.x);
    text += ", ";
    append_float(text, v.y);
    text += ", ";
    append_float(text, v.z);
    text += "]\n";
}

// A TOML basic string.
void append_string(std::string& text, std::string_view value) {
    text += '"';
    for (const char c : value) {
        if (c == '"' || c == '\\') {
            text += '\\';
            text += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            std::array<char, 8> escape{};
            std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
            text += escape.data();
        } else {
            text += c;
        }
    }
    text += '"';
}

void append_sphere(std::string& text, const Sphere& sphere, const std::string* name) {
    text += "\n[[sphere]]\n";
    if (name != nullptr) {
        text += "name = ";
        append_string(text, *name);
        text += '\n';
    }
    text += "color = [" + std::to_string(sphere.color.r) + ", " + std::to_string(sphere.color.g) + ", " +
            std::to_string(sphere.color.b) + "]\n";
    append_vector(text, "center", sphere.center);
    text += "radius = ";
    append_float(text, sphere.radius);
    text += '\n';
    if (sphere.hidden) text += "hidden = true\n";
}

// The numbers of the hidden spheres, in lines of some of them.
void append_hidden(std::string& text, const std::vector<Sphere>& spheres) {
    constexpr std::size_t in_a_line = 16;
    std::size_t count = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        if (!spheres[i].hidden) continue;
        text += count == 0 ? "hidden = [" : count % in_a_line == 0 ? ",\n    " : ", ";
        text += std::to_string(i);
        ++count;
    }
    if (count > 0) text += "]\n";
}

void append_light(std::string& text, const Light& light) {
    const auto append = [&](std::string_view key, double value) {
        text.append(key) += " = ";
        append_float(text, value);
        text += '\n';
    };
    text += "\n[light]\n";
    if (light.lights) text += "lights = " + std::to_string(*light.lights) + "\n";
    if (light.sky) append("sky", *light.sky);
    if (light.key != Light{}.key) append("key", light.key);
    if (!light.sun) return;
    append_vector(text, "sun", light.sun->direction);
    if (light.sun->strength) append("sun_strength", *light.sun->strength);
}

void append_camera(std::string& text, const Camera& camera) {
    append_vector(text, "eye", camera.eye);
    append_vector(text, "center", camera.center);
    append_vector(text, "right", camera.right);
    append_vector(text, "up", camera.up);
    if (camera.orthographic()) text += "projection = \"" + std::string(name_of(camera.projection)) + "\"\n";
}

// A number that reads back as the same float: what is the shortest for a float may lie too near to the middle of two.
std::string shortest_value(float value) {
    const std::string text = shortest(value);
    double read = 0.0;
    parse_double(text, read);
    return static_cast<float>(read) == value ? text : shortest(static_cast<double>(value));
}
std::string shortest_value(double value) { return shortest(value); }
std::string shortest_value(std::uint32_t value) { return std::to_string(value); }
std::string shortest_value(std::int32_t value) { return std::to_string(value); }

template <typename Number>
std::string value_in_words(Number value) {
    if constexpr (std::is_floating_point_v<Number>) {
        if (std::isnan(value)) return "nan";
    } else if constexpr (std::is_signed_v<Number>) {
        if (value == no_whole_number) return "nan";
    }
    return shortest_value(value);
}

// An array, or a string of lines where there are many.
template <typename Number>
void append_values(std::string& text, const std::vector<Number>& values) {
    constexpr std::size_t in_a_line = 12;
    const bool as_text = values.size() > most_sphere_tables;
    text += as_text ? "values = \"\"\"" : "values = [";
    for (std::size_t i = 0; i < values.size(); ++i) {
        const char* const gap = as_text ? " " : ", ";
        const char* const line_gap = as_text ? "\n" : ",\n    ";
        text += i % in_a_line != 0 ? gap : i > 0 ? line_gap : as_text ? "\n" : "";
        std::string word = value_in_words(values[i]);
        // As a TOML integer -0 would lose its sign, and a number beyond 64 bits would be wrong.
        constexpr std::size_t surely_in_64_bits = 18;
        const bool is_plain = word.find_first_not_of("-0123456789") == std::string::npos;
        if (!as_text && is_plain && (word == "-0" || word.size() > surely_in_64_bits)) word += ".0";
        text += word;
    }
    text += as_text ? "\n\"\"\"\n" : "]\n";
}

void append_words(std::string& text, const char* key, const std::vector<std::string>& words) {
    text.append(key) += " = [";
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += ", ";
        append_string(text, words[i]);
    }
    text += "]\n";
}

// Whether the values alone tell which words there are, and in which order.
bool speaks_for_itself(const Labels& labels) {
    std::uint32_t next = 0;
    for (const std::uint32_t number : labels.numbers) {
        if (number > next) return false;
        if (number == next) ++next;
    }
    return next == labels.words.size() && !labels.numbers.empty();
}

void append_property(std::string& text, const Property& property) {
    text += "\n[[property]]\nname = ";
    append_string(text, property.name);
    text += '\n';
    if (const auto* const labels = std::get_if<Labels>(&property.values)) {
        if (labels->numbers.size() <= most_sphere_tables && speaks_for_itself(*labels)) {
            std::vector<std::string> words;
            for (const std::uint32_t number : labels->numbers) words.push_back(labels->words[number]);
            return append_words(text, "values", words);
        }
        append_words(text, "words", labels->words);
        append_values(text, labels->numbers);
    } else if (const auto* const reals = std::get_if<std::vector<float>>(&property.values)) {
        text += "type = \"float\"\n";
        append_values(text, *reals);
    } else if (const auto* const wholes = std::get_if<std::vector<std::int32_t>>(&property.values)) {
        text += "type = \"int\"\n";
        append_values(text, *wholes);
    } else {
        append_values(text, std::get<std::vector<double>>(property.values));
    }
}

}  // namespace

std::string write_toml(const Scene& scene) {
    std::string text;
    if (scene.background != Background{}) text += "background = \"" + to_string(scene.background) + "\"\n";

    const bool as_text = scene.spheres.size() > most_sphere_tables;
    if (as_text) {
        text += "spheres = \"\"\"\n" + write_text_spheres(scene.spheres) + "\"\"\"\n";
        append_hidden(text, scene.spheres);
    }

    if (scene.camera != Camera{}) {
        text += "\n[camera]\n";
        append_camera(text, scene.camera);
    }
    if (scene.light != Light{}) append_light(text, scene.light);
    for (const SavedView& view : scene.views) {
        text += "\n[[view]]\nname = ";
        append_string(text, view.name);
        text += '\n';
        append_camera(text, view.camera);
    }
    if (as_text && !scene.names.empty()) {
        text += "\n[names]\n";
        for (const auto& [number, name] : scene.names) {
            text += std::to_string(number) + " = ";
            append_string(text, name);
            text += '\n';
        }
    }
    for (const Property& property : scene.properties) append_property(text, property);
    if (!as_text) {
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const auto name = scene.names.find(static_cast<std::uint32_t>(i));
            append_sphere(text, scene.spheres[i], name == scene.names.end() ? nullptr : &name->second);
        }
    }
    if (text.empty()) return "# An empty scene.\n";
    return text[0] == '\n' ? text.substr(1) : text;  // a table's head, without the blank line above
}

}  // namespace sphereview

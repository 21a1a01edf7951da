// Shared by the readers of the native format: values, and their places in the text. For sources that may include toml++.
#pragma once

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"
#include "scene/scene.hpp"

namespace sphereview {

// A file's name and whole text, for messages.
struct TomlText {
    const std::string& name;
    std::string_view content;
    std::vector<NumberLiteral> literals{};  // the content of strings that were emptied
};

[[noreturn]] void fail(const TomlText& document, const toml::source_position& place, const std::string& message);
[[noreturn]] void fail(const TomlText& document, const toml::node& node, const std::string& message);

// The byte at `place`, whose column counts characters.
std::size_t offset_of(const TomlText& document, const toml::source_position& place);

// The node for a message: "a string" or the number itself.
std::string found(const toml::node& node);
[[noreturn]] void wrong(const TomlText& document, const toml::node& node, const std::string& expected);

// The tables of `node`, each headed [[KEY]]. Throws InputError for anything else.
std::vector<const toml::table*> tables_in(const TomlText& document, const toml::node& node, const std::string& key);

std::string unknown_key(std::string_view key, const std::string& where, std::span<const std::string> known);

// The text inside a string value, with its place in the file; with escapes, which shift the text, the place of the whole value.
TextSource inside_string(const TomlText& document, const toml::value<std::string>& value);

// A table whose every key must be known.
class TableReader {
public:
    // `where` names the table in messages ("[camera]").
    TableReader(const TomlText& document, const toml::table& table, std::string where, std::span<const std::string> keys)
        : document_(document), table_(table), where_(std::move(where)) {
        for (const auto& [key, value] : table) {
            if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
            fail(document, key.source().begin, unknown_key(key.str(), where_, keys));
        }
    }

    const toml::node* find(std::string_view key) const { return table_.get(key); }

    const toml::node& require(std::string_view key) const {
        const toml::node* node = find(key);
        if (node == nullptr) fail(document_, table_, where_ + " has no '" + std::string(key) + "', which it needs");
        return *node;
    }

    double number(const toml::node& node, const std::string& expected) const {
        if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
        if (const auto* real = node.as_floating_point(); real != nullptr && std::isfinite(real->get())) return real->get();
        wrong(document_, node, expected);
    }

    glm::dvec3 vector(const toml::node& node, const std::string& key) const {
        const std::string expected = "'" + key + "' as three finite numbers [x, y, z]";
        const toml::array& array = three_of(node, expected);
        return {number(array[0], expected), number(array[1], expected), number(array[2], expected)};
    }

    Color color(const toml::node& node) const {
        const std::string expected = "'color' as three whole numbers [R, G, B] from 0 to 255";
        const toml::array& array = three_of(node, expected);
        std::array<std::uint8_t, 3> channels{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto* value = array[i].as_integer();
            if (value == nullptr || value->get() < 0 || value->get() > color_max) wrong(document_, array[i], expected);
            channels[i] = static_cast<std::uint8_t>(value->get());
        }
        return {channels[0], channels[1], channels[2]};
    }

    template <typename T>
    T value(const toml::node& node, const std::string& expected) const {
        const auto* typed = node.as<T>();
        if (typed == nullptr) wrong(document_, node, expected);
        return typed->get();
    }

private:
    const toml::array& three_of(const toml::node& node, const std::string& expected) const {
        const toml::array* array = node.as_array();
        if (array == nullptr) wrong(document_, node, expected);
        if (array->size() != 3) fail(document_, node, "found " + std::to_string(array->size()) + " values, expected " + expected);
        return *array;
    }

    const TomlText& document_;
    const toml::table& table_;
    std::string where_;
};

// Reads [[property]] of a scene of so many spheres; defined in toml_properties.cpp.
std::vector<Property> read_properties(const TomlText& document, const toml::node& node, std::size_t spheres);

}  // namespace sphereview

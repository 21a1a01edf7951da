// A JSON value, with its members in order. The library that reads and writes it is compiled once, in json.cpp.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "scene/sphere.hpp"

namespace sphereview {

class Json {
public:
    Json(std::nullptr_t = nullptr);
    Json(bool value);
    Json(double value);
    Json(std::int64_t value);
    template <std::integral Number>
    Json(Number value) : Json(static_cast<std::int64_t>(value)) {}
    template <std::convertible_to<std::string_view> Text>
    Json(const Text& text) : Json(from_text(text)) {}
    template <typename Value>
    Json(const std::optional<Value>& value) : Json(value ? Json(*value) : Json(nullptr)) {}
    template <std::ranges::range List>
    requires(!std::convertible_to<List, std::string_view>) Json(const List& values) : Json(array()) {
        for (const auto& value : values) push_back(value);
    }
    Json(std::initializer_list<Json> values);  // an object if all are of the form {"key", value}, else a list
    static Json array();
    static Json object();
    // Throws InputError with the place if `text` is not JSON or nests too deep. `text` stands at `origin` in the file `name`.
    static Json parse(std::string_view text, const std::string& name, TextPosition origin = {});

    // These give nothing for a value of another type. A missing member is null.
    bool is_null() const;
    bool is_object() const;
    std::optional<bool> boolean() const;
    std::optional<double> number() const;
    std::optional<std::int64_t> whole() const;
    std::optional<std::string> text() const;
    std::vector<Json> list() const;
    Json operator[](std::string_view key) const;

    void set(std::string_view key, const Json& value);  // null becomes an object
    void update(const Json& members);
    void erase(std::string_view key);
    void push_back(const Json& value);

    // In ASCII alone, which no terminal acts on. Bytes that are not UTF-8 become U+FFFD.
    std::string dump(int indent = -1) const;

private:
    struct Tree;

    explicit Json(std::shared_ptr<Tree> tree) : tree_(std::move(tree)) {}
    static Json from_text(std::string_view text);
    void dump_to(std::string& text, int indent, int depth) const;

    std::shared_ptr<Tree> tree_;  // null has none; shared: copied before a change
};

inline Json rgb(const Color& color) { return {color.r, color.g, color.b}; }

bool is_utf8(std::string_view text);

}  // namespace sphereview

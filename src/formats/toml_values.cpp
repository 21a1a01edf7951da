#include "formats/toml_values.hpp"

#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// "NAME:LINE:COLUMN: "
std::string in_words(const TomlText& document, const toml::source_position& place) {
    return place_in(document.name, {std::max<toml::source_index>(1, place.line), std::max<toml::source_index>(1, place.column)});
}

}  // namespace

std::size_t offset_of(const TomlText& document, const toml::source_position& place) {
    const std::string_view text = document.content;
    std::size_t offset = 0;
    for (toml::source_index line = 1; line < place.line; ++line) offset = text.find('\n', offset) + 1;
    for (toml::source_index column = 1; column < place.column && offset < text.size(); ++column) {
        do ++offset;
        while (offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xC0) == 0x80);
    }
    return offset;
}

void fail(const TomlText& document, const toml::source_position& place, const std::string& message) {
    throw InputError(in_words(document, place) + message);
}

void fail(const TomlText& document, const toml::node& node, const std::string& message) {
    fail(document, node.source().begin, message);
}

std::string found(const toml::node& node) {
    if (node.is_integer() || node.is_floating_point()) {
        std::ostringstream text;
        text << toml::node_view(node);
        return text.str();
    }
    if (const auto* text = node.as_string()) return in_quotes(text->get());
    std::ostringstream text;
    text << node.type();
    return "a value of type '" + text.str() + "'";
}

void wrong(const TomlText& document, const toml::node& node, const std::string& expected) {
    fail(document, node, "found " + found(node) + ", expected " + expected);
}

std::vector<const toml::table*> tables_in(const TomlText& document, const toml::node& node, const std::string& key) {
    const std::string expected = "'" + key + "' as tables, each headed [[" + key + "]]";
    const toml::array* array = node.as_array();
    if (array == nullptr) wrong(document, node, expected);
    std::vector<const toml::table*> tables;
    for (const toml::node& item : *array) {
        tables.push_back(item.as_table());
        if (tables.back() == nullptr) wrong(document, item, expected);
    }
    return tables;
}

std::string unknown_key(std::string_view key, const std::string& where, std::span<const std::string> known) {
    return "found the unknown key " + in_quotes(key) + " in " + where + ", expected one of " + joined(known, ", ") +
           did_you_mean(key, known);
}

TextSource inside_string(const TomlText& document, const toml::value<std::string>& value) {
    const toml::source_position begin = value.source().begin;
    TextPosition origin{begin.line, begin.column};
    std::string_view quotes = document.content.substr(offset_of(document, begin));
    const bool basic = quotes.starts_with('"');
    const std::string_view delimiter = quotes.substr(0, quotes.starts_with(R"(""")") ? 3 : 1);
    if (basic && quotes.substr(0, quotes.find(delimiter, delimiter.size())).find('\\') != std::string_view::npos) {
        return {in_words(document, begin) + "in the value's text", value.get(), {}};
    }
    if (quotes.starts_with(R"(""")") || quotes.starts_with("'''")) {
        quotes.remove_prefix(3);
        origin.column += 3;
        if (quotes.starts_with('\n') || quotes.starts_with("\r\n")) origin = {origin.line + 1, 1};
    } else {
        origin.column += 1;
    }
    const auto literal = std::ranges::find(document.literals, std::size_t{begin.line}, &NumberLiteral::line);
    return {document.name, literal != document.literals.end() ? literal->text : std::string_view(value.get()), origin};
}

}  // namespace sphereview

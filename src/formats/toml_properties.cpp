// Properties in the native format: [[property]] with a name, the values of all spheres, and what kind they are.
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/property_columns.hpp"
#include "formats/toml_values.hpp"

namespace sphereview {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr const char* type_syntax = R"('type' as "double", "float" or "int")";

NumberFault parse_value(std::string_view token, double& value) {
    if (token != "nan") return parse_double(token, value);
    value = no_value;
    return NumberFault::none;
}

// The kinds of values, and what messages call one of them.
enum class ValueType { real, small_real, whole, word };

const char* in_words(ValueType type) {
    switch (type) {
        case ValueType::whole: return "a whole number of 32 bits, or nan";
        case ValueType::word: return "the number of one of 'words', from 0";
        default: return "a finite number, or nan";
    }
}

class PropertyReader {
public:
    PropertyReader(const TomlText& document, const toml::table& table, std::size_t number, std::size_t spheres)
        : document_(document), reader_(document, table, "[[property]] " + std::to_string(number + 1), keys()), spheres_(spheres) {}

    Property read() {
        const toml::node& name = reader_.require("name");
        property_.name = reader_.value<std::string>(name, "'name' as a string");
        if (property_.name.empty()) wrong(document_, name, "a name");
        const toml::node* words = reader_.find("words");
        if (const toml::node* type = reader_.find("type")) {
            if (words != nullptr) fail(document_, *type, "found both 'type' and 'words', expected only one of them");
            read_type(*type);
        }
        if (words != nullptr) read_words(*words);
        const toml::node& values = reader_.require("values");
        const std::string expected = "'values' as an array, or a string of numbers";
        if (const toml::array* array = values.as_array()) {
            require_count(values, array->size());
            const bool are_strings =
                words == nullptr && reader_.find("type") == nullptr && !array->empty() && array->front().is_string();
            if (are_strings) {
                read_strings(*array);
            } else {
                begin();
                for (std::size_t i = 0; i < spheres_; ++i) set_value(i, *array->get(i));
            }
        } else if (const auto* text = values.as_string()) {
            begin();
            read_text(inside_string(document_, *text), values);
        } else {
            wrong(document_, values, expected);
        }
        return std::move(property_);
    }

private:
    static const std::vector<std::string>& keys() {
        static const std::vector<std::string> known = {"name", "type", "words", "values"};
        return known;
    }

    void read_type(const toml::node& node) {
        const auto text = reader_.value<std::string>(node, type_syntax);
        if (text == "float") {
            type_ = ValueType::small_real;
        } else if (text == "int") {
            type_ = ValueType::whole;
        } else if (text != "double") {
            wrong(document_, node, type_syntax);
        }
    }

    void read_words(const toml::node& node) {
        type_ = ValueType::word;
        const toml::array* array = node.as_array();
        const std::string expected = "'words' as an array of different strings";
        if (array == nullptr) wrong(document_, node, expected);
        std::set<std::string> known;
        for (const toml::node& word : *array) {
            labels_.words.push_back(reader_.value<std::string>(word, expected));
            if (!known.insert(labels_.words.back()).second) {
                fail(document_, word, "found " + in_quotes(labels_.words.back()) + " again, expected each word once");
            }
        }
    }

    void require_count(const toml::node& node, std::size_t count) const {
        if (count == spheres_) return;
        fail(document_, node,
             "found " + std::to_string(count) + " values, expected " + std::to_string(spheres_) + ", one for each sphere");
    }

    void read_strings(const toml::array& array) {
        std::map<std::string, std::uint32_t> numbers;
        for (const toml::node& value : array) {
            const auto word = reader_.value<std::string>(value, "a string, as the values before it");
            const auto [known, is_new] = numbers.try_emplace(word, static_cast<std::uint32_t>(labels_.words.size()));
            if (is_new) labels_.words.push_back(word);
            labels_.numbers.push_back(known->second);
        }
        property_.values = std::move(labels_);
    }

    void begin() {
        require_memory(spheres_ * sizeof(double), document_.name + ": the values of " + in_groups(spheres_) + " spheres need");
        switch (type_) {
            case ValueType::real: property_.values = std::vector<double>(spheres_); break;
            case ValueType::small_real: property_.values = std::vector<float>(spheres_); break;
            case ValueType::whole: property_.values = std::vector<std::int32_t>(spheres_); break;
            case ValueType::word:
                labels_.numbers.resize(spheres_);
                property_.values = std::move(labels_);
                break;
        }
    }

    void set_value(std::size_t sphere, const toml::node& node) {
        double value = no_value;
        if (const auto* whole = node.as_integer()) {
            value = static_cast<double>(whole->get());
        } else if (const auto* real = node.as_floating_point()) {
            value = std::isnan(real->get()) ? no_value : real->get();
        } else {
            wrong(document_, node, in_words(type_));
        }
        if (!set_number(property_, sphere, value)) wrong(document_, node, in_words(type_));
    }

    void read_text(const TextSource& text, const toml::node& node) {
        std::size_t count = 0;
        const auto expected = [&] { return "value " + std::to_string(count + 1) + " of " + std::to_string(spheres_); };
        for (TokenReader reader(text, std::size_t{0}, parse_value); !reader.at_end(); ++count) {
            if (count == spheres_) reader.fail("the end of the text after " + std::to_string(spheres_) + " values");
            const std::string_view token = reader.token();
            const double value = reader.number(expected);
            if (!set_number(property_, count, value)) text.fail(token, in_words(type_));
        }
        require_count(node, count);
    }

    const TomlText& document_;
    TableReader reader_;
    std::size_t spheres_;
    ValueType type_ = ValueType::real;
    Labels labels_{};
    Property property_{};
};

}  // namespace

std::vector<Property> read_properties(const TomlText& document, const toml::node& node, std::size_t spheres) {
    std::vector<Property> properties;
    std::set<std::string> names;
    for (const toml::table* table : tables_in(document, node, "property")) {
        properties.push_back(PropertyReader(document, *table, properties.size(), spheres).read());
        const std::string& name = properties.back().name;
        if (!names.insert(name).second) {
            fail(document, *table->get("name"), "found " + in_quotes(name) + " again, expected each name once");
        }
    }
    return properties;
}

}  // namespace sphereview

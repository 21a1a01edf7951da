// Shared by readers that keep properties: columns of values, read in a separate walk over the rows, which costs nothing if none is
// wanted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "formats/csv_values.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

enum class PropertyKind {
    found,      // whole numbers, numbers or words, by the values
    real,       // numbers
    whole,      // whole numbers, or numbers if one is not whole
    words,      //
    element,    // words, or the element's symbol if known
    magnitude,  // the length of the vector of three columns from `place` on
};

// A column of a file's rows.
struct PropertyColumn {
    std::string name;
    PropertyKind kind = PropertyKind::found;
    std::size_t place = 0;  // of the row's field, from 0
};

// The properties of a file.
struct FileProperties {
    std::vector<std::string> names{};  // of all properties
    std::vector<Property> kept{};      // the wanted properties
    std::vector<std::string> warnings{};
};

// The symbol of an element's word: "C" for "C1", "6" and "c". The word itself for an unknown element.
std::string element_in_words(std::string_view species);

// Adds a column. The name becomes UTF-8, with " 2" added if another column has it. Ignores columns without a name, and those beyond
// most_property_columns.
void add_column(std::vector<PropertyColumn>& columns, std::string_view name, PropertyKind kind, std::size_t place);
inline constexpr std::size_t most_property_columns = 1000;

// Whether a property of so many spheres is wanted.
bool is_wanted(const DataOptions& options, std::string_view name, std::size_t spheres);

// Gives a sphere another value; in a category the word with that number. False if the property cannot hold the number: then the
// sphere has no value, or keeps its word.
bool set_number(Property& property, std::size_t sphere, double value);

// Collects the values of a column, sphere by sphere.
class PropertyValues {
public:
    PropertyValues(const PropertyColumn& column, std::size_t count);

    const PropertyColumn& column() const { return column_; }
    // Whether words came behind numbers, so that all values must be added again.
    bool needs_words() const { return needs_words_; }
    bool has_too_many_words() const { return labels_.words.size() > most_words; }
    void begin_again();

    void add(std::string_view text, Commas commas);
    void add(double value) { numbers_.push_back(value); }

    // The most words of a category.
    static constexpr std::size_t most_words = 65'536;

    Property take();

private:
    void add_number(std::string_view text, Commas commas);
    void add_word(std::string_view text);

    PropertyColumn column_;
    std::size_t count_;
    bool is_whole_;  // all numbers so far are whole
    bool is_words_;  // a column of words
    bool needs_words_ = false;
    std::vector<std::int32_t> wholes_{};
    std::vector<double> numbers_{};
    Labels labels_{};
    std::map<std::string, std::uint32_t, std::less<>> word_numbers_{};  // by the file's word
    std::string last_word_{};
    std::uint32_t last_number_ = 0;
};

// Collects the values of the wanted columns.
class PropertyTable {
public:
    // `file`: its name in messages. commas: their meaning in numbers.
    PropertyTable(const std::vector<PropertyColumn>& columns, const DataOptions& options, std::size_t count,
                  const std::string& file, Commas commas = Commas::none);

    // Whether a walk, or another one, over the rows is needed. Call next_walk() before each.
    bool wants_rows() const;
    void next_walk();
    // One more than the last place that is read.
    std::size_t places() const { return places_; }

    // Adds the next sphere's row. text_at(place): a field, or "".
    template <typename TextAt>
    void add(const TextAt& text_at) {
        for (PropertyValues& values : values_) {
            if (walks_ > 1 && !values.needs_words()) continue;
            const PropertyColumn& column = values.column();
            if (column.kind == PropertyKind::magnitude) {
                values.add(magnitude(text_at(column.place), text_at(column.place + 1), text_at(column.place + 2)));
            } else {
                values.add(text_at(column.place), commas_);
            }
        }
    }

    // The properties, without columns that have no values.
    FileProperties take();

private:
    static double magnitude(std::string_view x, std::string_view y, std::string_view z);

    std::vector<std::string> names_{};
    std::vector<PropertyValues> values_{};
    Commas commas_;
    int walks_ = 0;
    std::size_t count_;
    std::string file_;
    std::size_t places_ = 0;
};

// Reads the wanted columns. walk(table) calls table.add() for all rows.
template <typename Walk>
FileProperties read_properties(const std::vector<PropertyColumn>& columns, const DataOptions& options, std::size_t count,
                               const std::string& file, const Walk& walk, Commas commas = Commas::none) {
    PropertyTable table(columns, options, count, file, commas);
    while (table.wants_rows()) {
        table.next_walk();
        walk(table);
    }
    return table.take();
}

// Moves properties into `data`, whose scene has the spheres of these values.
void add_properties(SphereData& data, FileProperties properties);

}  // namespace sphereview

// What readers share that keep more of a file than its spheres: columns of values, read in a walk of their own over the rows, so
// that who asks for none pays nothing.
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
    found,      // whole numbers, numbers or words, as the values show
    real,       // numbers
    whole,      // whole numbers, or numbers where one is none
    words,      //
    element,    // words that become the element's symbol where it is known
    magnitude,  // the length of the vector of three columns from `place` on
};

// A column of a file's rows.
struct PropertyColumn {
    std::string name;
    PropertyKind kind = PropertyKind::found;
    std::size_t place = 0;  // among the fields of a row, from 0
};

// What a file holds of its spheres.
struct FileProperties {
    std::vector<std::string> names{};  // of all that there are
    std::vector<Property> kept{};      // that were asked for
    std::vector<std::string> warnings{};
};

// What becomes of a word: "C" of "C1", "6" and "c". The word itself where no element is known.
std::string element_in_words(std::string_view species);

// Adds a column, whose name becomes UTF-8 and gets " 2" behind it where another has it. None without a name, nor beyond
// most_property_columns: nobody chooses among more.
void add_column(std::vector<PropertyColumn>& columns, std::string_view name, PropertyKind kind, std::size_t place);
inline constexpr std::size_t most_property_columns = 1000;

// Whether a property of so many spheres is asked for.
bool is_wanted(const DataOptions& options, std::string_view name, std::size_t spheres);

// Gives a sphere of a property another value; of a category the word with that number. False where the property cannot hold the
// number: then the sphere has no value, or, of a category, the one that it had.
bool set_number(Property& property, std::size_t sphere, double value);

// The values of one column while they are read, a sphere after the other.
class PropertyValues {
public:
    PropertyValues(const PropertyColumn& column, std::size_t count);

    const PropertyColumn& column() const { return column_; }
    // Whether words came behind numbers: then all must be given once more.
    bool needs_words() const { return needs_words_; }
    bool has_too_many_words() const { return labels_.words.size() > most_words; }
    void begin_again();

    void add(std::string_view text, Commas commas);
    void add(double value) { numbers_.push_back(value); }

    // As many words as a category may have; what has more is none.
    static constexpr std::size_t most_words = 65'536;

    Property take();

private:
    void add_number(std::string_view text, Commas commas);
    void add_word(std::string_view text);

    PropertyColumn column_;
    std::size_t count_;
    bool is_whole_;  // so far all are whole numbers
    bool is_words_;  // of words
    bool needs_words_ = false;
    std::vector<std::int32_t> wholes_{};
    std::vector<double> numbers_{};
    Labels labels_{};
    std::map<std::string, std::uint32_t, std::less<>> word_numbers_{};  // by what stands in the file
    std::string last_word_{};
    std::uint32_t last_number_ = 0;
};

// Those of the columns that are asked for, while they are read.
class PropertyTable {
public:
    // `file`: what messages call it. commas: what they are in numbers.
    PropertyTable(const std::vector<PropertyColumn>& columns, const DataOptions& options, std::size_t count,
                  const std::string& file, Commas commas = Commas::none);

    // Whether the rows are to be walked through, perhaps once more: next_walk() before each.
    bool wants_rows() const;
    void next_walk();
    // Behind the last place that is looked at.
    std::size_t places() const { return places_; }

    // The next sphere's row: text_at(place) gives a field, "" where there is none.
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

    // Columns that hold nothing at all are none.
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

// Reads them: walk(table) walks through all rows and calls table.add().
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

// Moves them to where they belong. The scene's spheres are those that the values are of.
void add_properties(SphereData& data, FileProperties properties);

}  // namespace sphereview

#include "formats/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/number.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

// So that a header of nothing but properties does not take much more memory than its text.
constexpr std::size_t most_properties = 10'000;
constexpr std::size_t longest_line = 1024;

constexpr auto types = std::to_array<std::pair<std::string_view, PlyType>>({{"char", PlyType::int8},
                                                                            {"int8", PlyType::int8},
                                                                            {"uchar", PlyType::uint8},
                                                                            {"uint8", PlyType::uint8},
                                                                            {"short", PlyType::int16},
                                                                            {"int16", PlyType::int16},
                                                                            {"ushort", PlyType::uint16},
                                                                            {"uint16", PlyType::uint16},
                                                                            {"int", PlyType::int32},
                                                                            {"int32", PlyType::int32},
                                                                            {"uint", PlyType::uint32},
                                                                            {"uint32", PlyType::uint32},
                                                                            {"float", PlyType::float32},
                                                                            {"float32", PlyType::float32},
                                                                            {"double", PlyType::float64},
                                                                            {"float64", PlyType::float64}});

constexpr auto encodings =
    std::to_array<std::pair<std::string_view, PlyEncoding>>({{"ascii", PlyEncoding::ascii},
                                                             {"binary_little_endian", PlyEncoding::little_endian},
                                                             {"binary_big_endian", PlyEncoding::big_endian}});

class HeaderReader {
public:
    explicit HeaderReader(const TextSource& source) : source_(source) {
        // A binary file may hold line ends of any kind behind its header, but the first line shows which the header has.
        const std::string_view text = source.text;
        const std::size_t first = text.find_first_of("\r\n");
        const bool ends_in_cr = first != std::string_view::npos && text[first] == '\r' && !text.substr(first + 1).starts_with('\n');
        header_.line_end = ends_in_cr ? '\r' : '\n';
    }

    PlyHeader read() {
        LineWalker lines(source_.text, header_.line_end);
        for (bool first = true; !lines.at_end(); first = false) {
            line_ = lines.step();
            words_ = words_of(line_.substr(0, longest_line));
            if (first) {
                if (words_.empty() || words_[0] != "ply") source_.fail(line_, "ply");
                continue;
            }
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") {
                if (!has_format_) source_.fail(words_[0], "the line format before it");
                header_.end = lines.offset();
                return std::move(header_);
            }
            read_line();
        }
        source_.fail(source_.text.size(), "the text ends, expected end_header");
    }

private:
    void read_line() {
        if (words_[0] == "format") {
            header_.encoding = named(encodings, 1, "ascii, binary_little_endian or binary_big_endian");
            has_format_ = true;
        } else if (words_[0] == "element") {
            PlyElement element{word(1, "the element's name")};
            const std::string_view count = word(2, "the number of elements");
            if (!parse_whole(count, element.count)) source_.fail(count, "the number of elements, a whole number");
            if (++properties_ > most_properties) fail_of_many();
            header_.elements.push_back(std::move(element));
        } else if (words_[0] == "property") {
            if (header_.elements.empty()) source_.fail(words_[0], "an element before it");
            if (++properties_ > most_properties) fail_of_many();
            PlyProperty property;
            const bool is_list = word(1, "the property's type") == "list";
            if (is_list) {
                property.count_type = named(types, 2, type_names);
                if (!is_whole(*property.count_type)) source_.fail(words_[2], "a whole type for the number of a list's values");
            }
            property.type = named(types, is_list ? 3 : 1, type_names);
            property.name = word(is_list ? 4 : 2, "the property's name");
            header_.elements.back().properties.push_back(property);
        } else {
            source_.fail(words_[0], "format, element, property, comment or end_header");
        }
    }

    std::string_view word(std::size_t place, const char* expected) const {
        if (place < words_.size()) return words_[place];
        source_.fail_behind(line_, expected);
    }

    template <typename Table>
    typename Table::value_type::second_type named(const Table& table, std::size_t place, const char* expected) const {
        const std::string_view name = word(place, expected);
        const auto found = std::ranges::find(table, name, [](const auto& row) { return row.first; });
        if (found == table.end()) source_.fail(name, expected);
        return found->second;
    }

    [[noreturn]] void fail_of_many() const {
        source_.fail(words_[0], "at most " + in_groups(most_properties) + " elements and properties");
    }

    static constexpr const char* type_names = "a type: char, uchar, short, ushort, int, uint, float, double, or a list";

    const TextSource& source_;
    PlyHeader header_{};
    std::string_view line_{};
    std::vector<std::string_view> words_{};  // of the line
    std::size_t properties_ = 0;             // and elements
    bool has_format_ = false;
};

}  // namespace

bool PlyElement::has_lists() const {
    return std::ranges::any_of(properties, [](const PlyProperty& property) { return property.count_type.has_value(); });
}

std::size_t PlyElement::size() const {
    std::size_t size = 0;
    for (const PlyProperty& property : properties) size += size_of(property.count_type.value_or(property.type));
    return size;
}

PlyHeader read_ply_header(const TextSource& source) { return HeaderReader(source).read(); }

}  // namespace sphereview

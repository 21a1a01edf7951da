#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atoms.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/point_lines.hpp"
#include "formats/sphere_data.hpp"
#include "formats/xyz_columns.hpp"

namespace sphereview {

namespace {

// Where a frame lies in the text.
struct XyzFrame {
    std::size_t comment = 0;  // where its line begins
    std::size_t comment_end = 0;
    AtomLines atoms{};
};

// Finds the frames of a text without looking at their atoms.
class XyzFinder {
public:
    XyzFinder(const TextSource& source, const PartOfFile& part)
        : source_(source),
          line_end_(line_end_of(source.text)),
          walker_(source.text, line_end_),
          numbers_behind_first_(part.numbers_behind_first) {}

    char line_end() const { return line_end_; }
    bool at_end() const { return walker_.at_end(); }
    // Where the next line begins.
    std::size_t offset() const { return walker_.offset(); }
    std::size_t numbers_behind_first() const { return numbers_behind_first_; }

    // Steps over the next frame, number `number` from 0; false when there is none.
    bool next(XyzFrame& frame, std::int64_t number, bool wanted) {
        TextSource line = source_;
        std::size_t begin = 0;
        do {
            if (walker_.at_end()) return false;
            begin = walker_.offset();
            line.text = source_.text.substr(0, walker_.step());
        } while (is_between_frames(line, begin));
        TokenReader reader(line, begin, line_ends);
        const std::string of_frame = " of frame " + std::to_string(number);
        const auto expected = [&] { return "the number of atoms" + of_frame; };
        const auto count = static_cast<std::size_t>(reader.integer(0, most_spheres, expected));
        check_behind_count(line, reader, number == 0, expected);

        if (walker_.at_end()) source_.fail_at_end("the comment" + of_frame);
        frame.comment = walker_.offset();
        frame.comment_end = walker_.step();
        frame.atoms = step_over_atoms(source_, walker_, count, wanted, of_frame);
        return true;
    }

    // The first line of lattice vectors behind the atoms, for a warning; "" where there is none.
    const std::string& vectors() const { return vectors_; }

private:
    // Blank lines, the `>` of ORCA, and the lattice as VEC1, VEC2 and VEC3.
    bool is_between_frames(const TextSource& line, std::size_t begin) {
        const TokenReader reader(line, begin);
        if (reader.at_end() || reader.token() == ">") return true;
        const std::string_view word = reader.token();
        const bool is_vector = word == "VEC1" || word == "VEC2" || word == "VEC3";
        if (is_vector && vectors_.empty()) vectors_ = source_.place(word) + "found " + in_quotes(word);
        return is_vector;
    }

    // Many programs write more behind the number: words, an energy, the lengths of a box. But where it is as much as an atom has
    // whose element is a number, and the first frame had less, one more atom stands there than was said.
    template <typename Expected>
    void check_behind_count(const TextSource& line, TokenReader& reader, bool is_first, const Expected& expected) {
        const std::string_view rest = line.text.substr(reader.offset());
        std::size_t numbers = 0;
        double ignored = 0.0;
        for (const std::string_view word : words_of(rest)) {
            if (numbers == atom_numbers || parse_any_double(word, ignored) != NumberFault::none) break;
            ++numbers;
        }
        if (is_first) numbers_behind_first_ = numbers;
        if (numbers == atom_numbers && numbers_behind_first_ < numbers) {
            reader.fail("the end of the line after " + expected());
        }
    }

    static constexpr std::size_t atom_numbers = 3;

    const TextSource& source_;
    char line_end_;
    LineWalker walker_;
    std::size_t numbers_behind_first_;  // behind the number of atoms of the first frame
    std::string vectors_{};
};

// Colours that are no part of 1 by so much are of 255.
constexpr double most_of_one = 1.5;

// Reads the lines of one piece.
class XyzAtomReader {
public:
    // largest_color: raised to the largest number of a colour.
    XyzAtomReader(const TextSource& source, const XyzLayout& layout, std::size_t count, const DataOptions& options,
                  double& largest_color)
        : text_(source.text),
          line_{source.name, {}, source.origin},
          layout_(layout),
          count_(count),
          options_(options),
          largest_color_(largest_color) {}

    LineAtom read(std::size_t begin, std::size_t end, std::size_t index) {
        line_.text = text_.substr(0, end);
        TokenReader reader(line_, begin, line_ends, parse_any_double);
        const auto the = [&](const char* what) { return [this, what, index] { return what + of_atom(index, count_); }; };
        LineAtom atom;
        const Element* element = &unknown_element();
        bool has_radius = false;
        bool has_color = false;
        std::size_t column = 0;
        for (const XyzColumn& next : layout_.columns) {
            reader.skip_tokens(next.first - column);
            column = next.first + columns_of(next.field);
            Sphere& sphere = atom.sphere;
            switch (next.field) {
                case XyzField::species:
                    atom.label = reader.word(the("the element"));
                    element = &element_of_species(atom.label);
                    break;
                case XyzField::position:
                    sphere.center.x = reader.number(the("the x"));
                    sphere.center.y = reader.number(the("the y"));
                    sphere.center.z = reader.number(the("the z"));
                    break;
                case XyzField::flat_position:
                    sphere.center.x = reader.number(the("the x"));
                    sphere.center.y = reader.number(the("the y"));
                    sphere.center.z = 0.0;
                    break;
                case XyzField::radius:
                    // OVITO's 0 is the usual radius.
                    sphere.radius = reader.number_or_0(the("the radius"));
                    has_radius = sphere.radius > 0.0;
                    break;
                case XyzField::color:
                    has_color = channel(reader, the("the red"), sphere.color.r);
                    has_color = channel(reader, the("the green"), sphere.color.g) && has_color;
                    has_color = channel(reader, the("the blue"), sphere.color.b) && has_color;
                    break;
            }
        }
        atom.is_virtual = is_virtual(*element);
        if (!has_radius) atom.sphere.radius = radius_of(*element, options_);
        if (!has_color) atom.sphere.color = element->color;
        return atom;
    }

private:
    // False for what is no part of layout_.full_color.
    template <typename Expected>
    bool channel(TokenReader& reader, const Expected& expected, std::uint8_t& channel) {
        const double value = reader.number_or_0(expected);
        largest_color_ = std::max(largest_color_, value);
        if (!(value >= 0.0 && value <= layout_.full_color * most_of_one)) return false;
        channel = static_cast<std::uint8_t>(std::lround(color_max * std::min(1.0, value / layout_.full_color)));
        return true;
    }

    std::string_view text_;
    TextSource line_;  // the text up to the line's end
    const XyzLayout& layout_;
    std::size_t count_;  // of the frame's atoms
    const DataOptions& options_;
    double& largest_color_;
};

// Where nothing names them, numbers behind the places of the first atom are columns by their place.
void add_further_columns(const TextSource& source, const XyzFrame& frame, char line_end, std::vector<PropertyColumn>& columns) {
    constexpr std::size_t named = 4;
    constexpr std::size_t most = 32;
    if (frame.atoms.count == 0) return;
    const std::size_t begin = frame.atoms.pieces[0];
    std::vector<std::string_view> words;
    split_line(source.text.substr(0, LineWalker(source.text, line_end, begin).step()).substr(begin), most, words);
    const auto is_number = [](std::string_view word) {
        double ignored = 0.0;
        return parse_any_double(word, ignored) == NumberFault::none;
    };
    if (words.size() <= named || !std::all_of(words.begin() + named, words.end(), is_number)) return;
    for (std::size_t i = named; i < words.size(); ++i)
        columns.push_back({"column" + std::to_string(i + 1), PropertyKind::found, i});
}

SphereData read_xyz_frame(const TextSource& source, const XyzFrame& frame, char line_end, const DataOptions& options) {
    const std::size_t count = frame.atoms.count;
    require_memory(count * sizeof(Sphere), source.name + ": " + in_groups(count) + " spheres need");
    XyzLayout layout = xyz_layout({source.name, source.text.substr(0, frame.comment_end), source.origin}, frame.comment);
    std::vector<double> largest_colors(frame.atoms.pieces.size());
    const auto read = [&] {
        return read_atom_lines(source, frame.atoms, line_end, [&](std::size_t piece) {
            return XyzAtomReader(source, layout, count, options, largest_colors[piece]);
        });
    };
    Atoms atoms = read();
    const auto largest_color = std::ranges::max_element(largest_colors);
    if (layout.full_color == 1.0 && largest_color != largest_colors.end() && *largest_color > most_of_one) {
        layout.full_color = color_max;
        atoms = read();
    }
    if (layout.is_plain) add_further_columns(source, frame, line_end, layout.properties);
    atoms.properties = read_word_properties(source, frame.atoms, line_end, layout.properties, options);
    return data_of(std::move(atoms), source.name, options, name_of_species);
}

}  // namespace

// A number, a comment, and an element before a position. A text scene has its colours and centres there.
bool shows_xyz(std::string_view head) {
    const auto is_whole = [](std::string_view word) { return word.find_first_not_of("0123456789") == std::string_view::npos; };
    const auto is_number = [](std::string_view word) {
        double ignored = 0.0;
        return parse_double(word, ignored) == NumberFault::none;
    };
    head = trimmed(head, white_space);
    const auto count = words_of(take_line(head));
    const std::string_view comment_line = take_line(head);
    const auto comment = words_of(comment_line);
    const auto atom = words_of(take_line(head));
    if (count.empty() || !is_whole(count[0]) || atom.empty()) return false;
    if (count.size() > 1) return !is_number(count[1]) && is_letter(atom[0][0]) && atom.size() > 3;
    if (comment.size() == 3 && std::all_of(comment.begin(), comment.end(), is_whole)) return false;
    if (lower_case(comment_line).find("properties=") != std::string::npos || is_letter(atom[0][0])) return true;
    return atom.size() > 3 && is_whole(atom[0]) && !comment.empty() && !is_number(comment[0]);
}

SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content), options.part.origin};
    if (!options.part.is_a_frame && is_bare_points(source.text)) return read_points(source.text, name, options);
    XyzFinder finder(source, options.part);
    const auto next = [&](XyzFrame& frame, std::int64_t number, bool wanted) { return finder.next(frame, number, wanted); };
    const FoundFrame<XyzFrame> found = find_frame<XyzFrame>(name, options, next);
    if (found.frames == 0) source.fail(source.text.size(), "the text is empty, expected the number of atoms of frame 0");
    SphereData data = read_xyz_frame(source, found.frame, finder.line_end(), options);
    if (!finder.vectors().empty()) data.warnings.push_back(finder.vectors() + " behind the atoms; the lattice is passed over");
    note_frames(data, found);
    return data;
}

std::optional<std::size_t> step_over_xyz(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    if (part.frames == 0 && is_bare_points(text)) return ended ? std::optional(text.size()) : std::nullopt;
    const TextSource source{name, whole_lines(text, ended), part.origin};
    XyzFinder finder(source, part);
    const auto length = step_over_frame<XyzFrame>(finder, ended, part.frames);
    if (length) part.numbers_behind_first = finder.numbers_behind_first();
    return length;
}

}  // namespace sphereview

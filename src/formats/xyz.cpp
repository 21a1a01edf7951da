#include <algorithm>
#include <cmath>

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
    std::string_view comment{};
    AtomLines atoms{};
};

class XyzFinder : public FrameFinder {
public:
    using Frame = XyzFrame;

    XyzFinder(const TextSource& source, const PartOfFile& part) : FrameFinder(source), numbers_behind_first_(part.of_first) {}

    std::size_t numbers_behind_first() const { return numbers_behind_first_; }

    bool next(XyzFrame& frame, std::int64_t number, bool wanted) {
        begin_frame(number);
        std::string_view line;
        do {
            if (at_end()) return false;
            line = walker_.step();
        } while (is_between_frames(line));
        TokenReader reader(source_, line);
        const auto expected = [&] { return "the number of atoms" + of_frame(); };
        const auto count = static_cast<std::size_t>(reader.integer(0, most_spheres, expected));
        check_behind_count(reader, number == 0);
        frame.comment = step("the comment");
        frame.atoms = step_over(count, wanted);
        return true;
    }

    // The first line of lattice vectors behind the atoms, for a warning; "" where there is none.
    const std::string& vectors() const { return vectors_; }

private:
    // Blank lines, the `>` of ORCA, and the lattice as VEC1, VEC2 and VEC3.
    bool is_between_frames(std::string_view line) {
        const TokenReader reader(source_, line);
        if (reader.at_end() || reader.token() == ">") return true;
        const std::string_view word = reader.token();
        const bool is_vector = word == "VEC1" || word == "VEC2" || word == "VEC3";
        if (is_vector && vectors_.empty()) vectors_ = source_.place(word) + "found " + in_quotes(word);
        return is_vector;
    }

    // Many programs write more behind the number: words, an energy, the lengths of a box. But where it is as much as an atom has
    // whose element is a number, and the first frame had less, one more atom stands there than was said.
    void check_behind_count(const TokenReader& reader, bool is_first) {
        const auto words = words_of(reader.rest());
        const auto numbers = static_cast<std::size_t>(std::ranges::find_if_not(words, is_number) - words.begin());
        if (is_first) numbers_behind_first_ = std::min(numbers, atom_numbers);
        if (numbers >= atom_numbers && numbers_behind_first_ < atom_numbers) {
            reader.fail("the end of the line after the number of atoms" + of_frame());
        }
    }

    static constexpr std::size_t atom_numbers = 3;

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
        : source_(source), layout_(layout), count_(count), options_(options), largest_color_(largest_color) {}

    LineAtom read(std::string_view line, std::size_t index) {
        TokenReader reader(source_, line, parse_any_double);
        const OfAtom the{index, count_};
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
                    atom.label = reader.word(the("element"));
                    element = &element_of_species(atom.label);
                    break;
                case XyzField::position: sphere.center = read_place(reader, the); break;
                case XyzField::flat_position:
                    sphere.center.x = reader.number(the("x"));
                    sphere.center.y = reader.number(the("y"));
                    sphere.center.z = 0.0;
                    break;
                case XyzField::radius:
                    // OVITO's 0 is the usual radius.
                    sphere.radius = reader.number_or_0(the("radius"));
                    has_radius = sphere.radius > 0.0;
                    break;
                case XyzField::color:
                    has_color = channel(reader, the("red"), sphere.color.r);
                    has_color = channel(reader, the("green"), sphere.color.g) && has_color;
                    has_color = channel(reader, the("blue"), sphere.color.b) && has_color;
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

    const TextSource& source_;
    const XyzLayout& layout_;
    std::size_t count_;  // of the frame's atoms
    const DataOptions& options_;
    double& largest_color_;
};

// Where nothing names them, numbers behind the places of the first atom are columns by their place.
void add_further_columns(std::string_view first_line, std::vector<PropertyColumn>& columns) {
    constexpr std::size_t named = 4;
    constexpr std::size_t most = 32;
    std::vector<std::string_view> words;
    split_line(first_line, most, words);
    if (words.size() <= named || !std::all_of(words.begin() + named, words.end(), is_number)) return;
    for (std::size_t i = named; i < words.size(); ++i)
        columns.push_back({"column" + std::to_string(i + 1), PropertyKind::found, i});
}

// Extended XYZ has no unit of time. CP2K writes "i = 3, time = 1.500, E = -17.1".
std::optional<FrameTime> time_in_comment(std::string_view comment) {
    const auto value = value_in_comment(comment, "time");
    return value ? frame_time(trimmed(*value, ",;"), "") : std::nullopt;
}

SphereData read_xyz_frame(const TextSource& source, const XyzFrame& frame, const DataOptions& options) {
    const std::size_t count = frame.atoms.count;
    XyzLayout layout = xyz_layout(source, frame.comment);
    std::vector<double> largest_colors(frame.atoms.pieces.size());
    const auto read = [&] {
        return read_atom_lines(source, frame.atoms, [&](std::size_t piece) {
            return XyzAtomReader(source, layout, count, options, largest_colors[piece]);
        });
    };
    Atoms atoms = read();
    const auto largest_color = std::ranges::max_element(largest_colors);
    if (layout.full_color == 1.0 && largest_color != largest_colors.end() && *largest_color > most_of_one) {
        layout.full_color = color_max;
        atoms = read();
    }
    if (layout.is_plain) add_further_columns(frame.atoms.first_line(source), layout.properties);
    atoms.properties = read_word_properties(source, frame.atoms, layout.properties, options);
    SphereData data = data_of(std::move(atoms), source.name, options, name_of_species);
    data.time = time_in_comment(frame.comment);
    return data;
}

}  // namespace

// A number, a comment, and an element before a position. A text scene has its colours and centres there.
bool shows_xyz(std::string_view head) {
    head = trimmed(head, white_space);
    const auto count = words_of(take_line(head));
    const std::string_view comment_line = take_line(head);
    const auto comment = words_of(comment_line);
    const auto atom = words_of(take_line(head));
    if (count.empty() || !is_digits(count[0]) || atom.empty()) return false;
    if (count.size() > 1) return !is_number(count[1]) && is_letter(atom[0][0]) && atom.size() > 3;
    if (comment.size() == 3 && std::all_of(comment.begin(), comment.end(), is_digits)) return false;
    if (lower_case(comment_line).find("properties=") != std::string::npos || is_letter(atom[0][0])) return true;
    return atom.size() > 3 && is_digits(atom[0]) && !comment.empty() && !is_number(comment[0]);
}

SphereData read_xyz(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content), options.part.origin};
    if (!options.part.is_a_frame && is_bare_points(source.text)) return read_points(source.text, name, options);
    XyzFinder finder(source, options.part);
    return read_wanted_frame(source, options, finder, "the number of atoms", [&](const XyzFrame& frame) {
        SphereData data = read_xyz_frame(source, frame, options);
        if (!finder.vectors().empty()) data.warnings.push_back(finder.vectors() + " behind the atoms; the lattice is passed over");
        return data;
    });
}

std::optional<std::size_t> step_over_xyz(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    if (part.frames == 0 && is_bare_points(text)) return ended ? std::optional(text.size()) : std::nullopt;
    const TextSource source{name, whole_lines(text, ended), part.origin};
    XyzFinder finder(source, part);
    const auto length = step_over_frame(finder, ended, part.frames);
    if (length) part.of_first = finder.numbers_behind_first();
    return length;
}

}  // namespace sphereview

#include <algorithm>
#include <span>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atom_names.hpp"
#include "formats/csv_values.hpp"
#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/point_lines.hpp"
#include "formats/point_radius.hpp"
#include "formats/sphere_data.hpp"
#include "formats/xyz_columns.hpp"

namespace sphereview {

namespace {

// Where a frame lies in the text.
struct XyzFrame {
    std::string_view comment{};
    bool is_tinker = false;
    AtomLines atoms{};
};

XyzLayout layout_of(const TextSource& source, const XyzFrame& frame) {
    return frame.is_tinker ? tinker_layout() : xyz_layout(source, frame.comment, frame.atoms);
}

// The first atom of TINKER's file of the same name, which has no line of comment: "1  O  0.0 0.0 0.0  1  2 3".
bool is_first_of_tinker(std::string_view line) {
    const std::string_view word = trimmed(line, white_space);
    if (!word.starts_with('1') || word.size() < 2 || !is_space(word[1])) return false;
    const auto words = words_of(word);
    return words.size() > 5 && is_letter(words[1][0]) && std::all_of(words.begin() + 2, words.begin() + 5, is_number) &&
           is_digits(words[5]);
}

class XyzFinder : public FrameFinder {
public:
    using Frame = XyzFrame;
    using FrameFinder::FrameFinder;

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
        frame.is_tinker = count > 0 && begins_tinker();
        frame.comment = frame.is_tinker ? reader.rest() : step("the comment");
        frame.atoms = step_over(count, wanted);
        return true;
    }

    // A line is cut that has fewer words than there are columns. So is one whose last number has fewer decimals than that column
    // has in many atoms before, where no column's decimals vary: programs write all places alike. A few decimals may be alike by
    // chance, and what is no plain number, as nan, has none of its own.
    bool holds_atom(const XyzFrame& frame, std::string_view line) const {
        if (frame.atoms.count == 0 || source_.offset_of(line) != frame.atoms.last) return true;
        const auto words = words_of(line);
        if (words.size() < width_of(frame)) return false;
        if (words.empty() || frame.atoms.count <= alike_lines || !begins_plain_number(words.back())) return true;
        std::vector<std::size_t> before;
        std::string_view text = source_.text.substr(0, frame.atoms.last);
        for (std::size_t i = 0; i < alike_lines; ++i) {
            text = trimmed(text, "\r\n");
            const std::string_view other = last_line(text);
            text.remove_suffix(other.size());
            std::vector<std::size_t> decimals;
            for (const std::string_view word : words_of(other)) decimals.push_back(decimals_of(word));
            if (i > 0 && decimals != before) return true;
            before = std::move(decimals);
        }
        if (before.size() != words.size() || before.back() < least_alike_decimals) return true;
        return decimals_of(words.back()) >= before.back();
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
        if (is_first) of_first_ = std::min(numbers, atom_numbers);
        if (numbers >= atom_numbers && of_first_ < atom_numbers) {
            reader.fail("the end of the line after the number of atoms" + of_frame());
        }
    }

    // Steps over the lengths and angles of TINKER's box, where they stand above its first atom.
    bool begins_tinker() {
        LineWalker ahead = walker_;
        if (ahead.at_end()) return false;
        const std::string_view line = ahead.step();
        if (is_first_of_tinker(line)) return true;
        if (!is_digits(trimmed(line, white_space).substr(0, 1))) return false;  // quickly, as most comments
        const auto words = words_of(line);
        constexpr std::size_t of_box = 6;
        if (words.size() != of_box || ahead.at_end() || !std::ranges::all_of(words, is_number)) return false;
        if (!is_first_of_tinker(LineWalker(ahead).step())) return false;
        walker_ = ahead;
        return true;
    }

    // How many columns a line has at least.
    std::size_t width_of(const XyzFrame& frame) const {
        try {
            return layout_of(source_, frame).width;
        } catch (const InputError&) {
            return 0;  // said where the frame is wanted
        }
    }

    // 0 where there is no point, also behind it.
    static std::size_t decimals_of(std::string_view word) {
        const std::size_t point = word.find('.');
        return point == std::string_view::npos ? 0 : word.size() - point - 1;
    }

    // Whether digits, perhaps with a sign and a point, begin like this: a lone sign is the least that a cut leaves.
    static bool begins_plain_number(std::string_view word) {
        if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
        return word.find_first_not_of("0123456789.") == std::string_view::npos && std::ranges::count(word, '.') <= 1;
    }

    static constexpr std::size_t atom_numbers = 3;
    static constexpr std::size_t alike_lines = 16;
    static constexpr std::size_t least_alike_decimals = 3;

    std::string vectors_{};
};

// What the atoms of a frame, or of a piece of it, show of its columns.
struct XyzNotes {
    double largest_color = 0.0;
    bool any_radius = false;
};

// Reads the lines of one piece.
class XyzAtomReader {
public:
    // notes: of the piece.
    XyzAtomReader(const TextSource& source, const XyzLayout& layout, std::size_t count, const DataOptions& options, XyzNotes& notes)
        : source_(source), layout_(layout), count_(count), options_(options), notes_(notes) {}

    LineAtom read(std::string_view line, std::size_t index) {
        TokenReader reader(source_, line, parse_any_double);
        const OfAtom the{index, count_};
        LineAtom atom;
        const Element* element = nullptr;
        bool has_radius = false;
        bool has_color = false;
        std::uint64_t type = 0;  // of an atom that has one instead of an element, from 1
        std::size_t column = 0;
        for (const XyzColumn& next : layout_.columns) {
            reader.skip_tokens(next.first - column);
            column = next.first + columns_of(next.field);
            Sphere& sphere = atom.sphere;
            switch (next.field) {
                case XyzField::species:
                    atom.label = reader.word(the("element"));
                    element = layout_.has_types && parse_whole(atom.label, type) ? &unknown_element()
                              : layout_.has_names ? &element_of_name(atom.label, "", NameColumns::unknown)
                                                  : &element_of_species(atom.label);
                    break;
                case XyzField::position: atom.is_nowhere = !read_place_if_any(reader, the, sphere.center); break;
                case XyzField::flagged_position:
                    atom.is_nowhere = !reader.number_if_any(the("x"), sphere.center.x);
                    reader.skip_tokens(1);
                    atom.is_nowhere = !reader.number_if_any(the("y"), sphere.center.y) || atom.is_nowhere;
                    reader.skip_tokens(1);
                    atom.is_nowhere = !reader.number_if_any(the("z"), sphere.center.z) || atom.is_nowhere;
                    reader.skip_tokens(1);
                    break;
                case XyzField::flat_position:
                    atom.is_nowhere = !reader.number_if_any(the("x"), sphere.center.x);
                    atom.is_nowhere = !reader.number_if_any(the("y"), sphere.center.y) || atom.is_nowhere;
                    sphere.center.z = 0.0;
                    break;
                case XyzField::radius:
                    // OVITO's 0 is the usual radius.
                    sphere.radius = reader.number_or(0.0, the("radius"));
                    has_radius = sphere.radius > 0.0;
                    break;
                case XyzField::color:
                    has_color = channel(reader, the("red"), sphere.color.r);
                    has_color = channel(reader, the("green"), sphere.color.g) && has_color;
                    has_color = channel(reader, the("blue"), sphere.color.b) && has_color;
                    break;
            }
        }
        if (element == nullptr) {
            if (!has_radius) atom.sphere.radius = options_.radius.value_or(unknown_element().radius);
            if (!has_color) atom.sphere.color = {color_max, color_max, color_max};
        } else {
            atom.is_virtual = is_virtual(*element);
            if (!has_radius) atom.sphere.radius = radius_of(*element, options_);
            if (!has_color) atom.sphere.color = type > 0 ? color_of_type(type) : element->color;
        }
        notes_.any_radius = notes_.any_radius || has_radius;
        return atom;
    }

private:
    // False for what is no part of layout_.full_color.
    template <typename Expected>
    bool channel(TokenReader& reader, const Expected& expected, std::uint8_t& channel) {
        const double value = reader.number_or(0.0, expected);
        if (value <= most_of_color) notes_.largest_color = std::max(notes_.largest_color, value);
        const auto byte = color_byte(value, layout_.full_color);
        channel = byte.value_or(0);
        return byte.has_value();
    }

    const TextSource& source_;
    const XyzLayout& layout_;
    std::size_t count_;  // of the frame's atoms
    const DataOptions& options_;
    XyzNotes& notes_;
};

// Where nothing names them, numbers behind the places of the first atom are columns by their place. named: how many come before.
void add_further_columns(std::string_view first_line, std::size_t named, std::vector<PropertyColumn>& columns) {
    constexpr std::size_t most = 32;
    std::vector<std::string_view> words;
    split_line(first_line, most, words);
    if (words.size() <= named || !std::ranges::all_of(std::span(words).subspan(named), is_number)) return;
    for (std::size_t i = named; i < words.size(); ++i)
        columns.push_back({"column" + std::to_string(i + 1), PropertyKind::found, i});
}

// Extended XYZ has no unit of time. CP2K writes "i = 3, time = 1.500, E = -17.1".
std::optional<FrameTime> time_in_comment(std::string_view comment) {
    const auto value = value_in_comment(comment, "time");
    return value ? frame_time(trimmed(*value, ",;"), "") : std::nullopt;
}

// The name of an atom that has a type instead of an element: "type 2".
std::string name_of_typed(std::string_view label) {
    return is_digits(label) ? "type " + std::string(label) : name_of_species(label);
}

SphereData read_xyz_frame(const TextSource& source, const XyzFrame& frame, const DataOptions& options) {
    const std::size_t count = frame.atoms.count;
    XyzLayout layout = layout_of(source, frame);
    std::vector<XyzNotes> notes(frame.atoms.pieces.size());
    const auto read = [&] {
        return read_atom_lines(source, frame.atoms,
                               [&](std::size_t piece) { return XyzAtomReader(source, layout, count, options, notes[piece]); });
    };
    Atoms atoms = read();
    XyzNotes all;
    for (const XyzNotes& of_piece : notes) {
        all.largest_color = std::max(all.largest_color, of_piece.largest_color);
        all.any_radius = all.any_radius || of_piece.any_radius;
    }
    if (const double full = full_color(all.largest_color); full != layout.full_color && all.largest_color > 0.0) {
        layout.full_color = full;
        atoms = read();
    }
    if (layout.is_plain) add_further_columns(frame.atoms.first_line(source), layout.width, layout.properties);
    atoms.properties = read_word_properties(source, frame.atoms, layout.properties, options);
    SphereData data = data_of(std::move(atoms), source.name, options, layout.has_types ? name_of_typed : name_of_species);
    data.time = time_in_comment(frame.comment);
    if (layout.has(XyzField::flagged_position))
        data.warnings.push_back(source.name + ": holds MOPAC's flags behind each coordinate; they are passed over");
    // What says neither what nor how large its atoms are holds points.
    const bool has_species = layout.has(XyzField::species) && !layout.has_types;
    if (!has_species && !all.any_radius) use_radius_of_points(data, source.name, options);
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
    const std::string converted = is_utf16(content) ? utf8_of_utf16(content) : "";
    const std::string_view text = text_of_file(converted.empty() ? content : std::string_view(converted));
    const TextSource source{name, text, options.part.origin};
    if (!options.part.is_a_frame && shows_points(text)) {
        require_frame(name, options.frame, 1);
        return read_csv(text, name, options);
    }
    XyzFinder finder(source, options.part);
    SphereData data = read_wanted_frame(source, options, finder, "the number of atoms", [&](const XyzFrame& frame) {
        SphereData data = read_xyz_frame(source, frame, options);
        if (!finder.vectors().empty()) data.warnings.push_back(finder.vectors() + " behind the atoms; the lattice is passed over");
        return data;
    });
    if (!converted.empty() && data.frames > 1) {
        data.warnings.push_back(name + ": a text in UTF-16 counts as one frame, though it has " + std::to_string(data.frames) +
                                ": --frame N shows each; saved as UTF-8 it has them all");
    }
    return data;
}

std::optional<std::size_t> step_over_xyz(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    if (part.frames == 0 && (is_utf16(text) || shows_points(text))) return ended ? std::optional(text.size()) : std::nullopt;
    return step_over_frame<XyzFinder>(text, ended, name, part, read_xyz_frame);
}

}  // namespace sphereview

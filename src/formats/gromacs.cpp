// GROMACS's .gro: for each frame a title, the number of atoms, a line for each, and the box. An atom's line has columns: 5 for the
// residue's number, 5 for its name, 5 for the atom's, 5 for its number, and then x, y and z in nanometres, each as wide as the
// distance between two decimal points.
#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atom_names.hpp"
#include "formats/atoms.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

constexpr double angstroms = 10.0;  // in a nanometre

constexpr std::size_t names_end = 20;  // where the first place begins
constexpr std::size_t narrowest = 4;   // that a place may be: "-0.1"
constexpr std::size_t widest = 64;

std::string_view gro_columns(std::string_view line, std::size_t begin, std::size_t end) {
    return line.size() <= begin ? "" : trimmed(line.substr(begin, end - begin), " ");
}

// How wide a place is in the line of an atom; 0 where that cannot be told.
std::size_t width_of_places(std::string_view line) {
    const std::size_t first = line.find('.', std::min(names_end, line.size()));
    const std::size_t second = first == std::string_view::npos ? first : line.find('.', first + 1);
    if (second == std::string_view::npos) return 0;
    const std::size_t width = second - first;
    return width >= narrowest && width <= widest ? width : 0;
}

// Finds the frames of a text without looking at their atoms.
class GroFinder {
public:
    GroFinder(const TextSource& source, char line_end) : source_(source), walker_(source.text, line_end) {}

    bool at_end() const { return walker_.at_end(); }
    // Where the next line begins.
    std::size_t offset() const { return walker_.offset(); }

    // Steps over the next frame, number `number` from 0; false when there is none.
    bool next(AtomLines& atoms, std::int64_t number, bool wanted) {
        const std::string_view rest = source_.text.substr(walker_.offset());
        if (rest.find_first_not_of(white_space) == std::string_view::npos) return false;
        const std::string of_frame = " of frame " + std::to_string(number);
        const auto expected = [&] { return "the number of atoms" + of_frame; };
        walker_.step();  // the title
        if (walker_.at_end()) source_.fail_at_end(expected());
        const std::size_t begin = walker_.offset();
        const TextSource line{source_.name, source_.text.substr(0, walker_.step()), source_.origin};
        const auto count = static_cast<std::size_t>(TokenReader(line, begin, line_ends).integer(0, most_spheres, expected));
        atoms = step_over_atoms(source_, walker_, count, wanted, of_frame);
        if (!walker_.at_end()) walker_.step();  // the box
        return true;
    }

private:
    const TextSource& source_;
    LineWalker walker_;
};

// Reads the lines of one piece.
class GroAtomReader {
public:
    GroAtomReader(const TextSource& source, std::size_t width, std::size_t count, const DataOptions& options)
        : source_(source), width_(width), count_(count), options_(options) {}

    LineAtom read(std::size_t begin, std::size_t end, std::size_t index) {
        const std::string_view line = source_.text.substr(begin, end - begin);
        LineAtom atom;
        for (int axis = 0; axis < 3; ++axis) atom.sphere.center[axis] = angstroms * coordinate(begin, line, axis, index);
        require_finite(source_, begin, atom.sphere.center, index, count_);
        atom.label = line.substr(0, names_end);
        show_as(atom, element_of(line.substr(5, 10)), options_);
        return atom;
    }

private:
    double coordinate(std::size_t begin, std::string_view line, int axis, std::size_t index) const {
        const std::size_t first = names_end + static_cast<std::size_t>(axis) * width_;
        const std::size_t last = first + width_;
        const std::string_view field = line.substr(std::min(line.size(), first), width_);
        const std::string_view word = trimmed(field, " ");
        double value = 0.0;
        // Behind the last one there may be nothing, not even blanks that the others have.
        const NumberFault fault = parse_double(word, value);
        if (fault == NumberFault::none) return value;
        const std::string expected = std::string(", expected the ") + "xyz"[axis] + of_atom(index, count_) + " in columns " +
                                     std::to_string(first + 1) + " to " + std::to_string(last) + ", " + expected_instead_of(fault);
        if (word.empty()) source_.fail(begin + line.size(), "the line ends" + expected);
        source_.fail(begin + static_cast<std::size_t>(word.data() - line.data()), "found " + in_quotes(word) + expected);
    }

    // By the names of residue and atom, which few of many atoms have for themselves.
    const Element& element_of(std::string_view names) {
        const auto [known, is_new] = elements_.try_emplace(names, nullptr);
        if (is_new) known->second = &element_of_name(gro_columns(names, 5, 10), gro_columns(names, 0, 5), NameColumns::unknown);
        return *known->second;
    }

    const TextSource& source_;
    std::size_t width_;  // of a place
    std::size_t count_;  // of the frame's atoms
    const DataOptions& options_;
    std::unordered_map<std::string_view, const Element*> elements_{};
};

// "SOL 1/OW"
std::string name_of_gro_atom(std::string_view label) {
    const std::string residue(gro_columns(label, 5, 10));
    return as_utf8(residue + " " + std::string(gro_columns(label, 0, 5)) + "/" + std::string(gro_columns(label, 10, 15)));
}

// Names, and the velocities in nm/ps behind the places, as wide as these.
FileProperties read_gro_properties(const TextSource& source, const AtomLines& lines, std::size_t width, char line_end,
                                   const DataOptions& options) {
    const std::size_t velocities = names_end + 3 * width;
    std::vector<PropertyColumn> columns = {{"element", PropertyKind::words, 0},
                                           {"atom", PropertyKind::words, 1},
                                           {"residue", PropertyKind::words, 2},
                                           {"residue_number", PropertyKind::whole, 3}};
    if (lines.count > 0) {
        LineWalker walker(source.text, line_end, lines.pieces[0]);
        const std::size_t length = walker.step() - lines.pieces[0];
        if (length > velocities + 2 * width) {
            for (std::size_t i = 0; i < 3; ++i) {
                columns.push_back({std::string("velocity.") + "xyz"[i], PropertyKind::real, 4 + i});
            }
            columns.push_back({"velocity", PropertyKind::magnitude, 4});
        }
    }
    const auto split = [&](std::size_t begin, std::size_t end, std::size_t, std::size_t, std::vector<std::string_view>& fields) {
        const std::string_view line = source.text.substr(begin, end - begin);
        const std::string_view residue = gro_columns(line, 5, 10);
        const std::string_view atom = gro_columns(line, 10, 15);
        const std::string_view symbol = element_of_name(atom, residue, NameColumns::unknown).symbol;
        fields.insert(fields.end(), {symbol.empty() ? atom : symbol, atom, residue, gro_columns(line, 0, 5)});
        for (std::size_t at = velocities; at < velocities + 3 * width; at += width) {
            fields.push_back(gro_columns(line, at, at + width));
        }
    };
    return read_line_properties(source, lines, line_end, columns, options, split);
}

SphereData read_gro_frame(const TextSource& source, const AtomLines& lines, char line_end, const DataOptions& options) {
    require_memory(lines.count * sizeof(Sphere), source.name + ": " + in_groups(lines.count) + " spheres need");
    std::size_t width = 0;
    if (lines.count > 0) {
        LineWalker walker(source.text, line_end, lines.pieces[0]);
        const std::size_t end = walker.step();
        width = width_of_places(source.text.substr(0, end).substr(lines.pieces[0]));
        if (width == 0) {
            throw InputError(source.place(lines.pieces[0]) +
                             "found no two decimal points behind column 20, expected x, y and z in columns of equal width");
        }
    }
    const auto reader = [&](std::size_t) { return GroAtomReader(source, width, lines.count, options); };
    Atoms atoms = read_atom_lines(source, lines, line_end, reader);
    atoms.properties = read_gro_properties(source, lines, width, line_end, options);
    return data_of(std::move(atoms), source.name, options, name_of_gro_atom);
}

bool is_gro_number(std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

bool shows_gromacs(std::string_view head) {
    take_line(head);
    const std::string_view count = trimmed(take_line(head));
    const std::string_view atom = take_line(head);
    if (!is_gro_number(count) || !is_gro_number(gro_columns(atom, 0, 5)) || !is_gro_number(gro_columns(atom, 15, names_end)))
        return false;
    const std::string_view name = gro_columns(atom, 10, 15);
    const std::size_t width = width_of_places(atom);
    if (name.empty() || !is_letter(name[0]) || width == 0) return false;
    double ignored = 0.0;
    return std::ranges::all_of(std::array<std::size_t, 3>{0, 1, 2}, [&](std::size_t axis) {
        const std::size_t first = names_end + axis * width;
        return parse_double(gro_columns(atom, first, first + width), ignored) == NumberFault::none;
    });
}

SphereData read_gromacs(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content), options.part.origin};
    const char line_end = line_end_of(source.text);
    GroFinder finder(source, line_end);
    const auto next = [&](AtomLines& atoms, std::int64_t number, bool wanted) { return finder.next(atoms, number, wanted); };
    const FoundFrame<AtomLines> found = find_frame<AtomLines>(name, options, next);
    if (found.frames == 0)
        source.fail(source.text.size(), "the text is empty, expected a title and the number of atoms of frame 0");
    SphereData data = read_gro_frame(source, found.frame, line_end, options);
    note_frames(data, found);
    return data;
}

std::optional<std::size_t> step_over_gromacs(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    const TextSource source{name, whole_lines(text, ended), part.origin};
    GroFinder finder(source, line_end_of(source.text));
    return step_over_frame<AtomLines>(finder, ended, part.frames);
}

}  // namespace sphereview

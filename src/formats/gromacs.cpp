// GROMACS's .gro: for each frame a title, the number of atoms, a line for each, and the box. An atom's line has columns: 5 for the
// residue's number, 5 for its name, 5 for the atom's, 5 for its number, and then x, y and z in nanometres, each as wide as the
// distance between two decimal points.
#include <algorithm>
#include <unordered_map>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_lines.hpp"
#include "formats/atom_names.hpp"
#include "formats/elements.hpp"

namespace sphereview {

namespace {

constexpr double angstroms = 10.0;  // in a nanometre

constexpr std::size_t names_end = 20;  // where the first place begins
constexpr std::size_t narrowest = 4;   // that a place may be: "-0.1"
constexpr std::size_t widest = 64;

// How wide a place is in the line of an atom; 0 where that cannot be told.
std::size_t width_of_places(std::string_view line) {
    const std::size_t first = line.find('.', std::min(names_end, line.size()));
    const std::size_t second = first == std::string_view::npos ? first : line.find('.', first + 1);
    if (second == std::string_view::npos) return 0;
    const std::size_t width = second - first;
    return width >= narrowest && width <= widest ? width : 0;
}

struct GroFrame {
    std::string_view title{};
    AtomLines atoms{};
};

class GroFinder : public FrameFinder {
public:
    using Frame = GroFrame;
    using FrameFinder::FrameFinder;

    bool next(GroFrame& frame, std::int64_t number, bool wanted) {
        if (nothing_follows()) return false;
        begin_frame(number);
        frame.title = walker_.step();
        const std::size_t count = step_over_count();
        width_ = at_end() ? 0 : width_of_places(LineWalker(walker_).step());
        frame.atoms = step_over(count, wanted);
        if (!at_end()) walker_.step();  // the box
        return true;
    }

    // The columns of places are full: a line that ends before is cut.
    bool holds_atom(const GroFrame& frame, std::string_view line) const {
        return frame.atoms.count == 0 || source_.offset_of(line) != frame.atoms.last || line.size() >= names_end + 3 * width_;
    }

private:
    std::size_t width_ = 0;  // of a place in the frame's first line
};

// Reads the lines of one piece.
class GroAtomReader {
public:
    GroAtomReader(const TextSource& source, std::size_t width, std::size_t count, const DataOptions& options)
        : source_(source), width_(width), count_(count), options_(options) {}

    LineAtom read(std::string_view line, std::size_t index) {
        LineAtom atom;
        for (int axis = 0; axis < 3; ++axis) atom.sphere.center[axis] = angstroms * coordinate(line, axis, index);
        require_finite(source_, line, atom.sphere.center, index, count_);
        atom.label = line.substr(0, names_end);
        show_as(atom, element_of(line.substr(5, 10)), options_);
        return atom;
    }

private:
    double coordinate(std::string_view line, int axis, std::size_t index) const {
        const std::size_t first = names_end + static_cast<std::size_t>(axis) * width_;
        const std::size_t last = first + width_;
        const std::string_view word = in_columns(line, first, last);
        double value = 0.0;
        // Behind the last one there may be nothing, not even blanks that the others have.
        const NumberFault fault = parse_double(word, value);
        if (fault == NumberFault::none) return value;
        const std::string expected = std::string("the ") + "xyz"[axis] + of_atom(index, count_) + " in columns " +
                                     std::to_string(first + 1) + " to " + std::to_string(last) + ", " + expected_instead_of(fault);
        if (word.empty()) source_.fail_behind(line, expected);
        source_.fail(word, expected);
    }

    // By the names of residue and atom, which few of many atoms have for themselves.
    const Element& element_of(std::string_view names) {
        const auto [known, is_new] = elements_.try_emplace(names, nullptr);
        if (is_new) known->second = &element_of_name(in_columns(names, 5, 10), in_columns(names, 0, 5), NameColumns::unknown);
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
    const std::string residue(in_columns(label, 5, 10));
    return as_utf8(residue + " " + std::string(in_columns(label, 0, 5)) + "/" + std::string(in_columns(label, 10, 15)));
}

// Names, and the velocities in nm/ps behind the places, as wide as these.
FileProperties read_gro_properties(const TextSource& source, const AtomLines& lines, std::size_t width,
                                   const DataOptions& options) {
    const std::size_t velocities = names_end + 3 * width;
    std::vector<PropertyColumn> columns = {{"element", PropertyKind::words, 0},
                                           {"atom", PropertyKind::words, 1},
                                           {"residue", PropertyKind::words, 2},
                                           {"residue_number", PropertyKind::whole, 3}};
    if (lines.count > 0 && lines.first_line(source).size() > velocities + 2 * width) {
        for (std::size_t i = 0; i < 3; ++i) columns.push_back({std::string("velocity.") + "xyz"[i], PropertyKind::real, 4 + i});
        columns.push_back({"velocity", PropertyKind::magnitude, 4});
    }
    const auto split = [&](std::string_view line, std::size_t, std::size_t, std::vector<std::string_view>& fields) {
        const std::string_view residue = in_columns(line, 5, 10);
        const std::string_view atom = in_columns(line, 10, 15);
        const std::string_view symbol = symbol_or_name(element_of_name(atom, residue, NameColumns::unknown), atom);
        fields.insert(fields.end(), {symbol, atom, residue, in_columns(line, 0, 5)});
        for (std::size_t at = velocities; at < velocities + 3 * width; at += width) {
            fields.push_back(in_columns(line, at, at + width));
        }
    };
    return read_line_properties(source, lines, columns, options, split);
}

SphereData read_gro_frame(const TextSource& source, const GroFrame& frame, const DataOptions& options) {
    const AtomLines& lines = frame.atoms;
    const std::string_view first = lines.first_line(source);
    const std::size_t width = width_of_places(first);
    if (lines.count > 0 && width == 0) {
        source.fail_at(first, "found no two decimal points behind column 20, expected x, y and z in columns of equal width");
    }
    const auto reader = [&](std::size_t) { return GroAtomReader(source, width, lines.count, options); };
    Atoms atoms = read_atom_lines(source, lines, reader);
    atoms.properties = read_gro_properties(source, lines, width, options);
    SphereData data = data_of(std::move(atoms), source.name, options, name_of_gro_atom);
    data.time = time_in_title(frame.title);
    return data;
}

}  // namespace

bool shows_gromacs(std::string_view head) {
    take_line(head);
    const std::string_view count = trimmed(take_line(head));
    const std::string_view atom = take_line(head);
    if (!is_digits(count) || !is_digits(in_columns(atom, 0, 5)) || !is_digits(in_columns(atom, 15, names_end))) return false;
    const std::string_view name = in_columns(atom, 10, 15);
    const std::size_t width = width_of_places(atom);
    if (name.empty() || !is_letter(name[0]) || width == 0) return false;
    const auto place = [&](std::size_t axis) { return in_columns(atom, names_end + axis * width, names_end + (axis + 1) * width); };
    return is_number(place(0)) && is_number(place(1)) && is_number(place(2));
}

SphereData read_gromacs(std::string_view content, const std::string& name, const DataOptions& options) {
    return read_frame_of<GroFinder>(content, name, options, "a title and the number of atoms", read_gro_frame);
}

std::optional<std::size_t> step_over_gromacs(std::string_view text, bool ended, const std::string& name, PartOfFile& part) {
    return step_over_frame<GroFinder>(text, ended, name, part, read_gro_frame);
}

}  // namespace sphereview

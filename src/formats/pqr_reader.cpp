// PQR: PDB's records of atoms with blanks between what they say, and at the end the atom's charge and radius.
#include <algorithm>
#include <array>
#include <span>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/pdb_records.hpp"

namespace sphereview {

namespace {

constexpr auto last_fields = std::to_array<const char*>({"x", "y", "z", "charge", "radius"});

bool is_pqr_number(std::string_view word) {
    double ignored = 0.0;
    return parse_double(word, ignored) == NumberFault::none;
}

// Which of the words of a line say what: ATOM, a number, the atom, its residue, perhaps a chain, the residue's number, and
// last_fields.
class PqrAtoms {
public:
    explicit PqrAtoms(const TextSource& source) : source_(source) {}

    // The atom of the line that begins at `begin`.
    MoleculeAtom atom(std::size_t begin, std::string_view line) {
        words_ = words_of(line.substr(0, longest_line));
        const std::size_t places = first_place();
        std::array<double, last_fields.size()> values{};
        for (std::size_t i = 0; i < last_fields.size(); ++i) values[i] = value(begin, line, places + i, last_fields[i]);
        MoleculeAtom atom;
        atom.position = {values[0], values[1], values[2]};
        atom.radius = values[4];
        if (atom.radius < 0.0) fail(words_[places + 4], "the atom's radius, 0 or above");
        const std::span names = std::span(words_).first(places);
        const auto name = [&](std::size_t i) { return i < names.size() ? names[i] : std::string_view(); };
        atom.atom = name(2);
        atom.residue = name(3);
        if (names.size() > 5) atom.chain = name(4);
        atom.residue_number = std::string(name(std::max<std::size_t>(4, names.size() - 1)));
        atom.element = &element_of_name(atom.atom, atom.residue, NameColumns::unknown);
        return atom;
    }

private:
    static constexpr std::size_t longest_line = 1024;  // that is looked at

    // Where x stands: five numbers end the line. Where more stands behind them, what would be a chain is none if it is a number.
    std::size_t first_place() const {
        const std::size_t count = words_.size();
        const std::size_t usual = count - std::min(count, last_fields.size());
        const bool ends_so =
            usual >= 5 && usual <= 6 && std::all_of(words_.end() - last_fields.size(), words_.end(), is_pqr_number);
        if (ends_so) return usual;
        return count > 4 && !is_pqr_number(words_[4]) ? 6 : 5;
    }

    double value(std::size_t begin, std::string_view line, std::size_t place, const char* what) const {
        const std::string expected = std::string("the atom's ") + what;
        if (place >= words_.size()) source_.fail(begin + line.size(), "the line ends, expected " + expected);
        double number = 0.0;
        const NumberFault fault = parse_double(words_[place], number);
        if (fault != NumberFault::none) fail(words_[place], expected + ", " + expected_instead_of(fault));
        return number;
    }

    [[noreturn]] void fail(std::string_view word, const std::string& expected) const { source_.fail(word, expected); }

    const TextSource& source_;
    std::vector<std::string_view> words_{};  // of the line
};

}  // namespace

// Atoms as PDB has them, but with a charge of more decimals than an occupancy has, and nothing behind the radius.
bool shows_pqr(std::string_view head) {
    while (!head.empty()) {
        const std::string_view line = take_line(head);
        if (!is_pdb_atom(line)) {
            if (!line.empty() && !line.starts_with("REMARK") && !line.starts_with("TITLE") && !line.starts_with("HEADER"))
                return false;
            continue;
        }
        const auto words = words_of(line);
        if (words.size() < 9 || !std::all_of(words.end() - 5, words.end(), is_pqr_number)) return false;
        const std::string_view charge = words[words.size() - 2];
        constexpr std::size_t decimals_of_occupancy = 2;
        const std::size_t point = charge.find('.');
        return point != std::string_view::npos && charge.size() - point - 1 > decimals_of_occupancy;
    }
    return false;
}

SphereData read_pqr(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    const PdbFrame frame = find_pdb_frame(source.text, options.frame);
    if (!frame.has_atoms) fail_without_atoms(source, "a record ATOM or HETATM");
    require_frame(name, options.frame, frame.frames);
    require_memory(frame.count * sizeof(Sphere), name + ": " + in_groups(frame.count) + " spheres need");
    MoleculeScene scene(frame.count, options);
    PqrAtoms atoms(source);
    LineWalker lines(source.text.substr(0, frame.end), line_end_of(source.text), frame.begin);
    while (!lines.at_end()) {
        const std::size_t begin = lines.offset();
        const std::string_view line = source.text.substr(begin, lines.step() - begin);
        if (is_pdb_atom(line)) scene.add(atoms.atom(begin, line));
    }
    SphereData data = scene.take(name);
    data.frames = frame.frames;
    return data;
}

}  // namespace sphereview

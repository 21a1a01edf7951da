// The Protein Data Bank's format 3.3, and what other programs write in its columns: names of atoms from column 13, no columns of
// elements, residues of four letters, hydrogens as 1HB. Not by gemmi's reader, which gives the atoms another order, reads names
// without their columns, and takes twice the memory and time.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/pdb_records.hpp"

namespace sphereview {

namespace {

// A field's columns, from 0, and what it holds.
struct Field {
    std::size_t begin;
    std::size_t end;
    const char* what;
};
constexpr std::array<Field, 3> coordinates = {{{30, 38, "x"}, {38, 46, "y"}, {46, 54, "z"}}};
constexpr std::size_t columns_read = 78;  // up to the element; the charge behind it is not drawn

bool is_organic(std::string_view residue) { return is_water(residue) || is_polymer(residue); }

// What the columns hold, without blanks; "" behind the line's end.
std::string_view columns(std::string_view line, std::size_t begin, std::size_t end) {
    return line.size() <= begin ? "" : trimmed(line.substr(begin, end - begin), " ");
}

// How the residues of a file write names. PDB leaves column 13 free where the element's symbol has one letter. A residue that has
// such a symbol in column 13 ("C1  ") does not heed that, and of one that shows neither the rest of the file tells.
class NameStyles {
public:
    explicit NameStyles(std::string_view text) {
        std::string_view last = "\n";  // no residue's name
        Style* style = nullptr;
        for (LineWalker lines(text, line_end_of(text)); !lines.at_end();) {
            const std::size_t begin = lines.offset();
            const std::string_view line = text.substr(begin, lines.step() - begin);
            if (!is_pdb_atom(line) || line.size() < 20) continue;
            const std::string_view residue = columns(line, 17, 20);
            if (residue != last) style = is_organic(residue) ? &organic_ : &others_[residue];
            last = residue;
            style->note(line.substr(12, 4), style == &organic_);
        }
        rest_ = organic_;
        if (organic_.free || organic_.left) return;
        for (const auto& [name, other] : others_) {
            rest_.free = rest_.free || other.free;
            rest_.left = rest_.left || other.left;
        }
    }

    // `residue`: not one of water, amino acids and nucleotides.
    NameColumns of(std::string_view residue) const {
        const auto own = others_.find(residue.substr(0, 3));
        return own != others_.end() && (own->second.free || own->second.left) ? own->second.columns() : rest_.columns();
    }

private:
    struct Style {
        bool free = false;  // a name begins in column 14
        bool left = false;  // a name with a symbol of one letter begins in column 13, and does not fill all four columns

        // In organic residues all symbols have one letter, but for selenium's.
        void note(std::string_view name, bool organic) {
            const bool is_short = name[0] != ' ' && name[3] == ' ';
            const bool one_letter = std::string_view("CHNOPS").find(name[0]) != std::string_view::npos;
            const bool two_letters = organic ? name == "SE  " : is_letter(name[1]);
            free = free || (name[0] == ' ' && name[1] != ' ');
            left = left || (is_short && one_letter && !two_letters);
        }

        NameColumns columns() const { return free && !left ? NameColumns::aligned : NameColumns::unknown; }
    };

    static bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

    Style organic_{};                             // of water, amino acids and nucleotides
    std::map<std::string_view, Style> others_{};  // of the other residues, by three letters
    Style rest_{};                                // of a residue that shows nothing itself
};

class PdbAtoms {
public:
    explicit PdbAtoms(const TextSource& source) : source_(source) {}

    // The atom of the line that begins at `begin`.
    MoleculeAtom atom(std::size_t begin, std::string_view line, bool wants_texts) {
        const std::size_t zero = line.substr(0, columns_read).find('\0');
        if (zero != std::string_view::npos) source_.fail(begin + zero, "found a zero byte, expected text");
        MoleculeAtom atom;
        atom.position.x = coordinate(begin, line, coordinates[0]);
        atom.position.y = coordinate(begin, line, coordinates[1]);
        atom.position.z = coordinate(begin, line, coordinates[2]);
        atom.atom = columns(line, 12, 16);
        atom.alternative = columns(line, 16, 17);
        // Residues of four letters (TIP3) take the column of chains of two.
        const std::string_view four = columns(line, 17, 21);
        const bool has_four = line[20] == ' ' || line[21] == ' ' || is_water(four);
        atom.residue = has_four ? four : columns(line, 17, 20);
        atom.chain = has_four ? columns(line, 21, 22) : columns(line, 20, 22);
        atom.residue_number = columns(line, 22, 27);  // with the insertion code, or a fifth digit
        const std::string_view occupancy = columns(line, 54, 60);
        if (parse_double(occupancy, atom.occupancy) != NumberFault::none) atom.occupancy = 1.0;
        atom.element = &element_of(line.substr(12, 4), atom.residue, columns(line, 76, 78));
        if (wants_texts) atom.texts = {.b_factor = columns(line, 60, 66), .occupancy = occupancy, .charge = columns(line, 78, 80)};
        return atom;
    }

private:
    double coordinate(std::size_t begin, std::string_view line, const Field& field) const {
        double value = 0.0;
        const std::string_view text = line.substr(std::min(line.size(), field.begin), field.end - field.begin);
        const std::string_view word = trimmed(text, " ");
        if (line.size() >= field.end && parse_double(word, value) == NumberFault::none) return value;
        const std::string expected = std::string(", expected the atom's ") + field.what + " in columns " +
                                     std::to_string(field.begin + 1) + " to " + std::to_string(field.end);
        if (line.size() < field.end) source_.fail(begin + line.size(), "the line ends" + expected);
        const std::size_t place = word.empty() ? field.begin : static_cast<std::size_t>(word.data() - line.data());
        source_.fail(begin + place, "found " + in_quotes(word.empty() ? text : word) + expected + ", a number");
    }

    // `symbol`: what the columns of elements hold, which may be something else altogether.
    const Element& element_of(std::string_view name, std::string_view residue, std::string_view symbol) {
        const Element* element = find_element(symbol);
        const bool organic = is_organic(residue);
        const bool is_doubtful = residue == "DUM" || (symbol.size() == 2 && organic);  // CA of ALA is no calcium
        if (element != nullptr && !is_doubtful) return *element;
        if (element == nullptr && is_dummy(symbol)) return dummy_in(residue);
        if (organic) return element_of_name(name, residue, NameColumns::unknown);
        if (!styles_) styles_.emplace(source_.text);
        return element_of_name(name, residue, styles_->of(residue));
    }

    const TextSource& source_;
    std::optional<NameStyles> styles_{};  // once they count
};

}  // namespace

SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, content};
    const PdbFrame frame = find_pdb_frame(content, options.frame, options.part);
    if (!frame.has_atoms) fail_without_atoms(source, "a record ATOM or HETATM");
    require_frame(name, options.frame, frame.frames);
    require_memory(frame.count * sizeof(Sphere), name + ": " + in_groups(frame.count) + " spheres need");
    MoleculeScene scene(frame.count, options, name);
    PdbAtoms atoms(source);
    LineWalker lines(content.substr(0, frame.end), line_end_of(content), frame.begin);
    while (!lines.at_end()) {
        const std::size_t begin = lines.offset();
        const std::string_view line = content.substr(begin, lines.step() - begin);
        if (is_pdb_atom(line)) scene.add(atoms.atom(begin, line, scene.wants_texts()));
    }
    SphereData data = scene.take();
    data.frames = frame.frames;
    data.next_frame = frame.next;
    return data;
}

}  // namespace sphereview

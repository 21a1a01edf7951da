// The Protein Data Bank's format 3.3, and what other programs write in its columns: names of atoms from column 13, no columns of
// elements, residues of four letters, hydrogens as 1HB. Not by gemmi's reader, which gives the atoms another order, reads names
// without their columns, and takes twice the memory and time.
#include <map>
#include <optional>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/pdb_records.hpp"

namespace sphereview {

namespace {

constexpr std::size_t columns_read = 78;  // up to the element; the charge behind it is not drawn

bool is_organic(std::string_view residue) { return is_water(residue) || is_polymer(residue); }

// How the residues of a file write names. PDB leaves column 13 free where the element's symbol has one letter. A residue that has
// such a symbol in column 13 ("C1  ") does not heed that, and of one that shows neither the rest of the file tells.
class NameStyles {
public:
    explicit NameStyles(std::string_view text) {
        std::string_view last = "\n";  // no residue's name
        Style* style = nullptr;
        for (LineWalker lines(text, line_end_of(text)); !lines.at_end();) {
            const std::string_view line = lines.step();
            if (!is_pdb_atom(line) || line.size() < 20) continue;
            const std::string_view residue = in_columns(line, 17, 20);
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

    Style organic_{};                             // of water, amino acids and nucleotides
    std::map<std::string_view, Style> others_{};  // of the other residues, by three letters
    Style rest_{};                                // of a residue that shows nothing itself
};

class PdbAtoms {
public:
    explicit PdbAtoms(const TextSource& source) : source_(source) {}

    MoleculeAtom atom(std::string_view line, bool wants_texts) {
        const std::size_t zero = line.substr(0, columns_read).find('\0');
        if (zero != std::string_view::npos) source_.fail_at(line.substr(zero), "found a zero byte, expected text");
        MoleculeAtom atom;
        for (int axis = 0; axis < 3; ++axis) atom.position[axis] = coordinate(line, axis);
        atom.atom = in_columns(line, 12, 16);
        atom.alternative = in_columns(line, 16, 17);
        read_residue(line, atom);
        const std::string_view occupancy = in_columns(line, 54, 60);
        if (parse_double(occupancy, atom.occupancy) != NumberFault::none) atom.occupancy = 1.0;
        atom.element = &element_of(line.substr(12, 4), atom.residue, in_columns(line, 76, 78));
        if (wants_texts)
            atom.texts = {.b_factor = in_columns(line, 60, 66), .occupancy = occupancy, .charge = in_columns(line, 78, 80)};
        return atom;
    }

private:
    // Residues of four letters (TIP3) take the column of chains of two.
    void read_residue(std::string_view line, MoleculeAtom& atom) {
        const std::string_view four = in_columns(line, 17, 21);
        const bool has_four = line[20] == ' ' || line[21] == ' ' || is_organic(four) || !has_chains_of_two();
        atom.residue = has_four ? four : in_columns(line, 17, 20);
        atom.chain = has_four ? in_columns(line, 21, 22) : in_columns(line, 20, 22);
        atom.residue_number = in_columns(line, 22, 27);  // with the insertion code, or a fifth digit
        // Behind four letters the fifth digit stands before the others.
        if (has_four && line[20] != ' ' && is_digits(line.substr(21, 5))) {
            atom.chain = "";
            atom.residue_number = in_columns(line, 21, 27);
        }
    }

    // Where the columns of both are full, residues of three letters show that they are chains'.
    bool has_chains_of_two() {
        if (has_chains_of_two_) return *has_chains_of_two_;
        has_chains_of_two_ = false;
        for (LineWalker lines(source_.text, line_end_of(source_.text)); !lines.at_end() && !*has_chains_of_two_;) {
            const std::string_view line = lines.step();
            if (!is_pdb_atom(line) || line.size() < 22 || line[20] == ' ' || line[21] == ' ') continue;
            has_chains_of_two_ = line[17] == ' ' || (is_organic(in_columns(line, 17, 20)) && !is_organic(in_columns(line, 17, 21)));
        }
        return *has_chains_of_two_;
    }

    double coordinate(std::string_view line, int axis) const {
        constexpr std::size_t width = 8;
        const std::size_t begin = 30 + width * static_cast<std::size_t>(axis);
        const std::size_t end = begin + width;
        const std::string_view word = in_columns(line, begin, end);
        double value = 0.0;
        if (line.size() >= end && parse_double(word, value) == NumberFault::none) return value;
        const std::string expected =
            std::string("the atom's ") + "xyz"[axis] + " in columns " + std::to_string(begin + 1) + " to " + std::to_string(end);
        const std::string advice = may_be_pqr_atom(line) ? "; a PQR is known by a name that ends with .pqr" : "";
        if (line.size() < end) source_.fail_behind(line, expected + advice);
        source_.fail(word.empty() ? line.substr(begin, width) : word, expected + ", a number" + advice);
    }

    // `symbol`: what the columns of elements hold, which may be something else altogether.
    const Element& element_of(std::string_view name, std::string_view residue, std::string_view symbol) {
        const Element* element = find_element(symbol);
        const bool organic = is_organic(residue);
        const bool is_doubtful = residue == "DUM" || may_be_guessed(symbol, residue);
        if (element != nullptr && !is_doubtful) return *element;
        if (element == nullptr && is_dummy(symbol)) return dummy_in(residue);
        if (organic) return element_of_name(name, residue, NameColumns::unknown);
        if (!styles_) styles_.emplace(source_.text);
        return element_of_name(name, residue, styles_->of(residue));
    }

    const TextSource& source_;
    // Once they count:
    std::optional<NameStyles> styles_{};
    std::optional<bool> has_chains_of_two_{};
};

}  // namespace

SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, text_of_file(content)};
    PdbAtoms atoms(source);
    return read_pdb_frame(source, options, false,
                          [&](std::string_view line, bool wants_texts) { return atoms.atom(line, wants_texts); });
}

}  // namespace sphereview

// The Protein Data Bank's format 3.3, as gemmi reads it. gemmi reads a coordinate that is no number as 0. So this file checks the
// coordinates of the wanted model's atoms and gives gemmi only those lines.
#include <array>
#include <gemmi/pdb.hpp>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"

namespace sphereview {

namespace {

// A field's columns, from 0, and what it holds.
struct Field {
    std::size_t begin;
    std::size_t end;
    const char* what;
};
constexpr std::array<Field, 3> coordinates = {{{30, 38, "x"}, {38, 46, "y"}, {46, 54, "z"}}};
constexpr std::size_t columns_read = 78;  // up to the element; the charge behind it is often wrong, and not drawn

bool is_record(std::string_view line, std::string_view record) { return trimmed(line.substr(0, 6), " ") == record; }

// Takes the atoms of one frame out of a file and sees that their places are numbers: gemmi takes what is none for 0.
class FrameFilter {
public:
    FrameFilter(const TextSource& source, std::int64_t wanted) : source_(source), wanted_(wanted) {
        LineWalker lines(source.text, line_end_of(source.text));
        while (!lines.at_end()) {
            const std::size_t begin = lines.offset();
            take_record(begin, source.text.substr(begin, lines.step() - begin));
        }
    }

    // How many frames there are: models, or what END separates, as some programs do.
    std::int64_t frames() const { return frames_; }

    bool has_atoms() const { return has_atoms_; }

    // The records of the wanted frame's atoms.
    const std::string& atoms() const { return atoms_; }

private:
    void take_record(std::size_t begin, std::string_view line) {
        if (line.starts_with("ATOM") || line.starts_with("HETATM")) {
            if (!open_) ++frames_;
            open_ = has_atoms_ = true;
            if (frames_ - 1 != wanted_) return;
            check(begin, line);
            atoms_.append(line.substr(0, columns_read)) += '\n';
        } else if (is_record(line, "MODEL")) {
            ++frames_;
            open_ = true;
        } else if (is_record(line, "ENDMDL") || is_record(line, "END")) {
            open_ = false;
        }
    }

    void check(std::size_t begin, std::string_view line) const {
        for (const Field& field : coordinates) {
            const std::string expected = std::string(", expected the atom's ") + field.what + " in columns " +
                                         std::to_string(field.begin + 1) + " to " + std::to_string(field.end);
            if (line.size() < field.end) source_.fail(begin + line.size(), "the line ends" + expected);
            const std::string_view text = line.substr(field.begin, field.end - field.begin);
            const std::string_view word = trimmed(text, " ");
            double ignored = 0.0;
            if (parse_double(word, ignored) == NumberFault::none) continue;
            const std::size_t place = word.empty() ? field.begin : static_cast<std::size_t>(word.data() - line.data());
            source_.fail(begin + place, "found " + in_quotes(word.empty() ? text : word) + expected + ", a number");
        }
    }

    const TextSource& source_;
    std::int64_t wanted_;
    std::int64_t frames_ = 0;
    bool open_ = false;  // more atoms are of the same frame
    bool has_atoms_ = false;
    std::string atoms_{};
};

gemmi::Structure read_structure(const std::string& atoms, const std::string& name) {
    try {
        return gemmi::read_pdb_from_memory(atoms.data(), atoms.size(), name);
    } catch (const std::runtime_error& error) {
        throw InputError(name + ": the atoms cannot be read: " + error.what());
    }
}

std::string number_of(const gemmi::Residue& residue) { return residue.seqid.num.has_value() ? residue.seqid.str() : std::string(); }

}  // namespace

SphereData read_pdb(std::string_view content, const std::string& name, const DataOptions& options) {
    // Beside the text: gemmi's atoms, ours and the spheres, from lines of 81 bytes.
    require_memory(content.size() * (sizeof(gemmi::Atom) + sizeof(MoleculeAtom) + sizeof(Sphere)) / 81, name + ": its atoms need");
    const TextSource source{name, content};
    const FrameFilter filter(source, options.frame);
    if (!filter.has_atoms()) fail_without_atoms(source, "a record ATOM or HETATM");
    require_frame(name, options.frame, filter.frames());

    const gemmi::Structure structure = read_structure(filter.atoms(), name);
    std::vector<MoleculeAtom> atoms;
    for (const gemmi::Model& model : structure.models) {
        for (const gemmi::Chain& chain : model.chains) {
            for (const gemmi::Residue& residue : chain.residues) {
                for (const gemmi::Atom& atom : residue.atoms) {
                    const Element* element = find_element(atom.element.name());
                    atoms.push_back({.position = {atom.pos.x, atom.pos.y, atom.pos.z},
                                     .element = element != nullptr ? element : &unknown_element(),
                                     .chain = chain.name,
                                     .residue = residue.name,
                                     .residue_number = number_of(residue),
                                     .atom = atom.name,
                                     .alternative = std::string_view(&atom.altloc, atom.altloc == '\0' ? 0 : 1),
                                     .occupancy = atom.occ});
                }
            }
        }
    }
    return {scene_of(atoms, options), filter.frames()};
}

}  // namespace sphereview

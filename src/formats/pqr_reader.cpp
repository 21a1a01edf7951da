// PQR: PDB's records of atoms with blanks between what they say, and at the end the atom's charge and radius.
#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/atom_names.hpp"
#include "formats/lines.hpp"
#include "formats/macromolecule.hpp"
#include "formats/pdb_records.hpp"

namespace sphereview {

namespace {

constexpr auto last_fields = std::to_array<const char*>({"x", "y", "z", "charge", "radius"});

// Reads ATOM, a number, the atom, its residue, perhaps a chain, the residue's number, and last_fields.
class PqrAtoms {
public:
    explicit PqrAtoms(const TextSource& source) : source_(source) {}

    MoleculeAtom atom(std::string_view line) {
        words_.clear();
        split_line(line, most_words, words_);
        const std::size_t places = read_values(line);
        MoleculeAtom atom;
        atom.position = {values_[0], values_[1], values_[2]};
        atom.radius = values_[4];
        if (atom.radius < 0.0) source_.fail(words_[places + 4], "the atom's radius, 0 or above");
        atom.atom = words_[2];
        atom.residue = words_[3];
        if (places > fewest_names) atom.chain = words_[4];
        atom.residue_number = std::string(words_[places - 1]);
        atom.element = &element_of(atom.atom, atom.residue);
        atom.texts.charge = words_[places + 3];
        atom.texts.radius = words_[places + 4];
        return atom;
    }

private:
    static constexpr std::size_t fewest_names = 5;  // without a chain
    static constexpr std::size_t most_words = 16;   // that are looked at

    // Reads last_fields, and returns where they begin: five numbers end the line. Where more stands behind them, what would be a
    // chain is none if it is a number.
    std::size_t read_values(std::string_view line) {
        const std::size_t usual = words_.size() - std::min(words_.size(), last_fields.size());
        const bool may_end_so = usual == fewest_names || usual == fewest_names + 1;
        std::size_t read = 0;
        while (may_end_so && read < last_fields.size() && parse_double(words_[usual + read], values_[read]) == NumberFault::none)
            ++read;
        if (read == last_fields.size()) return usual;
        const std::size_t places = fewest_names + (words_.size() > 4 && !is_number(words_[4]) ? 1 : 0);
        for (std::size_t i = 0; i < last_fields.size(); ++i) {
            const std::string expected = std::string("the atom's ") + last_fields[i];
            if (places + i >= words_.size()) source_.fail_behind(line, expected);
            const NumberFault fault = parse_double(words_[places + i], values_[i]);
            if (fault != NumberFault::none) source_.fail(words_[places + i], expected + ", " + expected_instead_of(fault));
        }
        return places;
    }

    // Few names of many atoms are new.
    const Element& element_of(std::string_view atom, std::string_view residue) {
        constexpr std::size_t most_kept = 4096;
        if (elements_.size() > most_kept) elements_.clear();
        key_.assign(residue).append(1, ' ').append(atom);
        const auto [known, is_new] = elements_.try_emplace(key_, nullptr);
        if (is_new) known->second = &element_of_name(atom, residue, NameColumns::unknown);
        return *known->second;
    }

    const TextSource& source_;
    std::vector<std::string_view> words_{};  // of the line
    std::array<double, last_fields.size()> values_{};
    std::string key_{};
    std::unordered_map<std::string, const Element*> elements_{};
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
        if (words.size() < 9 || !std::all_of(words.end() - 5, words.end(), is_number)) return false;
        const std::string_view charge = words[words.size() - 2];
        constexpr std::size_t decimals_of_occupancy = 2;
        const std::size_t point = charge.find('.');
        return point != std::string_view::npos && charge.size() - point - 1 > decimals_of_occupancy;
    }
    return false;
}

SphereData read_pqr(std::string_view content, const std::string& name, const DataOptions& options) {
    const TextSource source{name, without_byte_order_mark(content)};
    PqrAtoms atoms(source);
    return read_pdb_frame(source, options, true, [&](std::string_view line, bool) { return atoms.atom(line); });
}

}  // namespace sphereview

// Shared by PDB and mmCIF: atoms of residues of chains, some in alternative places.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/property_columns.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// Texts about an atom, beside the drawn values.
struct AtomTexts {
    std::string_view b_factor{};
    std::string_view occupancy{};
    std::string_view charge{};  // "2+", "-1", "0.25"
    std::string_view radius{};
};

struct MoleculeAtom {
    glm::dvec3 position{};  // in angstrom
    const Element* element = &unknown_element();
    std::string_view chain{};
    std::string_view residue{};      // "ALA"
    std::string residue_number{};    // with the insertion code: "52A"
    std::string_view atom{};         // "CA"
    std::string_view alternative{};  // "A", "B"; "" for an atom with one place
    double occupancy = 1.0;          // the part of the atom at this place; finite
    double radius = 0.0;             // 0: the element's
    AtomTexts texts{};               // only where MoleculeScene::wants_texts()
};

// An atom that may have other places in the file.
struct AlternativePlace {
    std::size_t sphere = 0;
    std::size_t run = 0;  // of consecutive atoms of one residue
    std::string_view chain{};
    std::string number{};
    std::string_view residue{};
    std::string_view atom{};
    std::string_view alternative{};
    double occupancy = 1.0;
};

// The spheres of the places that are not kept, ascending: all places together would overlap. Alternatives of a residue with an atom
// in common form a group. Of each group the alternative with the highest occupancy is kept, the first of several, as in ChimeraX.
// Atoms that it lacks come from the next one, unless that is another residue.
std::vector<std::size_t> surplus_places(std::vector<AlternativePlace> places);

// Makes spheres of atoms, each in one place, with names such as "A/ALA 52A/CA" if there are not too many.
class MoleculeScene {
public:
    // `atoms`: how many will be added; their texts must stay in place. `name`: the file's, for messages. has_radii: the file has
    // radii instead of occupancies and B factors. Throws MemoryError.
    MoleculeScene(std::size_t atoms, const DataOptions& options, const std::string& name, bool has_radii = false);

    bool wants_texts() const { return wants_texts_; }
    void add(const MoleculeAtom& atom);
    SphereData take();

private:
    void add_values(const MoleculeAtom& atom);

    bool named_;
    DataOptions options_;
    Scene scene_{};
    std::vector<AlternativePlace> places_{};
    std::vector<std::size_t> virtual_sites_{};  // numbers of their spheres
    std::string name_;
    PropertyTable properties_;
    bool wants_texts_;
    // The present residue:
    std::string_view chain_{};
    std::string number_{};
    std::size_t run_ = 0;
};

// Throws InputError for a file without atoms. `expected`: what an atom looks like.
[[noreturn]] void fail_without_atoms(const TextSource& source, const std::string& expected);

}  // namespace sphereview

// What PDB and mmCIF have in common: atoms of residues of chains, some of them in alternative places.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "formats/elements.hpp"
#include "formats/lines.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

struct MoleculeAtom {
    glm::dvec3 position{};  // in angstrom
    const Element* element = &unknown_element();
    std::string_view chain{};
    std::string_view residue{};      // "ALA"
    std::string residue_number{};    // with the insertion code: "52A"
    std::string_view atom{};         // "CA"
    std::string_view alternative{};  // "A", "B"; "" of an atom with one place
    double occupancy = 1.0;          // how much of the atom is there
};

// The atoms as spheres, called "A/ALA 52A/CA" where they are not too many. Of the alternatives of a residue only that of the
// highest occupancy is kept, the first of several, as ChimeraX does: all of them at once would overlap.
Scene scene_of(std::span<const MoleculeAtom> atoms, const DataOptions& options);

// Throws InputError for a file without an atom; `expected` says what one looks like.
[[noreturn]] void fail_without_atoms(const TextSource& source, const std::string& expected);

}  // namespace sphereview

// What PDB and mmCIF have in common: atoms of residues of chains, some of them in alternative places.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// Makes spheres of atoms, called "A/ALA 52A/CA" where they are not too many. Of the alternatives of a residue only that of the
// highest occupancy is kept, the first of several, as ChimeraX does: all of them at once would overlap.
class MoleculeScene {
public:
    // `atoms`: how many will be added, of which the texts stay where they are.
    MoleculeScene(std::size_t atoms, const DataOptions& options);

    void add(const MoleculeAtom& atom);
    Scene take();

private:
    // An atom of the residue that has other places.
    struct Place {
        std::size_t sphere;
        std::string_view alternative;
        double occupancy;
    };

    void end_residue();

    bool named_;
    std::optional<double> radius_;
    Scene scene_{};
    // Of the residue that goes on:
    std::size_t first_ = 0;  // its first sphere
    std::string_view chain_{};
    std::string number_{};
    std::vector<Place> places_{};
    std::vector<std::string> names_{};
};

// Throws InputError for a file without an atom; `expected` says what one looks like.
[[noreturn]] void fail_without_atoms(const TextSource& source, const std::string& expected);

}  // namespace sphereview

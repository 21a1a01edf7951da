// What PDB and mmCIF have in common: atoms of residues of chains, some of them in alternative places.
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

// What PDB and mmCIF say of an atom as text, beside what is drawn.
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
    std::string_view alternative{};  // "A", "B"; "" of an atom with one place
    double occupancy = 1.0;          // how much of the atom is there; finite
    double radius = 0.0;             // its own; 0: that of the element
    AtomTexts texts{};               // only where MoleculeScene::wants_texts()
};

// An atom of which the file may hold other places.
struct AlternativePlace {
    std::size_t sphere = 0;
    std::size_t run = 0;  // of the atoms of one residue that stand together
    std::string_view chain{};
    std::string number{};
    std::string_view residue{};
    std::string_view atom{};
    std::string_view alternative{};
    double occupancy = 1.0;
};

// The spheres of places that are not kept, ascending: all places at once would overlap. The alternatives of a residue that have an
// atom in common are a group, and each group is chosen for itself: the alternative with the highest occupancy, the first of
// several, as ChimeraX does. What it lacks comes from the next, unless that is another residue.
std::vector<std::size_t> surplus_places(std::vector<AlternativePlace> places);

// Makes spheres of atoms, called "A/ALA 52A/CA" where they are not too many, each in one place.
class MoleculeScene {
public:
    // `atoms`: how many will be added, of which the texts stay where they are.
    // `name`: of the file, for messages. has_radii: it says them itself, instead of occupancies and B factors. Throws MemoryError.
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
    std::vector<std::size_t> virtual_sites_{};  // their spheres
    std::string name_;
    PropertyTable properties_;
    bool wants_texts_;
    // Of the residue that goes on:
    std::string_view chain_{};
    std::string number_{};
    std::size_t run_ = 0;
};

// Throws InputError for a file without an atom; `expected` says what one looks like.
[[noreturn]] void fail_without_atoms(const TextSource& source, const std::string& expected);

}  // namespace sphereview

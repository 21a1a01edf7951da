// Guesses elements by the names of atoms, for PDB without columns of elements and mmCIF without type_symbol.
#pragma once

#include <string_view>

#include "formats/elements.hpp"

namespace sphereview {

// How a file writes names of atoms in four columns.
enum class NameColumns {
    aligned,  // as in PDB, the symbol ends in the second column: CA of an amino acid is " CA ", calcium "CA  "
    unknown   // left-justified, or not in columns
};

// Whether a residue is water, by programs' names: "HOH", "SOL", "TIP3".
bool is_water(std::string_view residue);

// Whether a residue is an amino acid or nucleotide, also by simulation programs' names: "ALA", "HSD", "NALA", "DG", "RA5".
bool is_polymer(std::string_view residue);

// Whether a symbol in a file may have been guessed from the beginning of the atom's name: CA of ALA is no calcium. In UNK, which is
// an amino acid to some programs and any molecule to others, only if amino acids have such names.
bool may_be_guessed(std::string_view symbol, std::string_view residue);

// Whether the atom is a whole residue, as ions are: CA of CA, SOD of SOD, Na+ of NA+.
bool is_ion(std::string_view name, std::string_view residue);

// The element of a dummy's name or symbol in a residue: in UNX and UNL, X is an atom of unknown element.
const Element& dummy_in(std::string_view residue);

// The element of a crystal's site by its label: "CaM2", "Wat1" (the oxygen of water), "AlT1". The element of sites T, M and X is
// unknown.
const Element& element_of_site(std::string_view label);

// The element of an atom by its name, its residue and the names' columns. `name`: four columns if aligned. Amino acids, nucleotides
// and water hold no metal, so CA is carbon there; an ion has its residue's name. The virtual site for names that mean no atom (MW,
// EPW, LP1, the Drude particle DOH2, atoms of the residue DUM).
const Element& element_of_name(std::string_view name, std::string_view residue, NameColumns columns);

}  // namespace sphereview

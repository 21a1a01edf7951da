// Elements of atoms that a file only names, as PDB without the columns of elements and mmCIF without type_symbol.
#pragma once

#include <string_view>

#include "formats/elements.hpp"

namespace sphereview {

// How a file writes the names of atoms in their four columns.
enum class NameColumns {
    aligned,  // as PDB has it: the element's symbol ends in the second column, so CA of an amino acid is " CA ", calcium "CA  "
    unknown   // left-justified throughout, or not in columns at all
};

// Of the molecules of water, by the names that programs give them: "HOH", "SOL", "TIP3".
bool is_water(std::string_view residue);

// Of amino acids and nucleotides, also by the names of programs for simulations: "ALA", "HSD", "NALA", "DG", "RA5".
bool is_polymer(std::string_view residue);

// Whether a symbol beside an atom may be made of the atom's name, which it only begins with: CA of ALA is no calcium. Of UNK, which
// is an amino acid to some programs and any molecule to others, it may be where amino acids have such names.
bool may_be_guessed(std::string_view symbol, std::string_view residue);

// Whether the atom is its whole residue, as those of ions are: CA of CA, SOD of SOD, Na+ of NA+.
bool is_ion(std::string_view name, std::string_view residue);

// What a dummy's name, or its symbol, stands for in a residue: in UNX and UNL, X is an atom of which nobody knows the element.
const Element& dummy_in(std::string_view residue);

// The element of a crystal's site by its label alone: "CaM2", "Wat1" (the oxygen of water), "AlT1". T, M and X are sites of which
// only the file's author knows the element.
const Element& element_of_site(std::string_view label);

// The element of an atom by its name, its residue and how the names are written. `name`: four columns where they are aligned.
// Amino acids, nucleotides and water hold no metal, so CA is carbon there; an ion has its residue's name. What is no atom (MW, EPW,
// LP1, the Drude particle DOH2, atoms of the residue DUM) is the virtual site.
const Element& element_of_name(std::string_view name, std::string_view residue, NameColumns columns);

}  // namespace sphereview

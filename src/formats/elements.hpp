// The usual colours and radii of the chemical elements.
#pragma once

#include <cstdint>
#include <string_view>

#include "scene/sphere.hpp"

namespace sphereview {

struct Element {
    std::string_view symbol;  // "Fe"; "" for the unknown element
    Color color;
    double radius;  // in angstrom; the table names its source
};

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The element of a symbol in any letter case; D and T are hydrogen. Null for none.
const Element* find_element(std::string_view symbol);

// The same, or by CHARMM's name of an ion: SOD, POT, CLA, CES.
const Element* find_ion(std::string_view name);

// For atoms of unknown element: at most as large as carbon.
const Element& unknown_element();

// For sites in files of atoms that are no atoms: virtual sites of models of water, lone pairs, Drude particles, ghosts, dummies.
// Smaller than any atom, so that it hides none.
const Element& virtual_site();

inline bool is_virtual(const Element& element) { return &element == &virtual_site(); }

// Whether `species` is a program's name for such a site: X, Xx, Bq, O-Bq, O:, Gh(O), @O, O_ghost, Du, LP, EP, M, MW, Tv (a vector
// of the lattice), or the atomic number 0.
bool is_dummy(std::string_view species);

// The name of a file's atom among the elements: the symbol, or without one the atom's name. A virtual site with the name of an atom
// is X.
std::string_view symbol_or_name(const Element& element, std::string_view name);

// The element of a file's word for an atom: a symbol, a symbol with more behind its letters ("C1", "Fe2+", "O_w"), two letters of
// which the first is a symbol ("OW", "CG1"), an ion of CHARMM ("SOD"), or an atomic number; the virtual site for is_dummy(). Else
// the unknown element.
const Element& element_of_species(std::string_view species);

// The colour of a type, from 1, that is no element: one of eight that people with colour-blindness can tell apart (Okabe and Ito
// 2008).
Color color_of_type(std::uint64_t type);

}  // namespace sphereview

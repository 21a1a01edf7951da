#include "formats/atom_names.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/text.hpp"

namespace sphereview {

namespace {

// In alphabetical order, for std::ranges::binary_search.
constexpr auto waters = std::to_array<std::string_view>(
    {"DOD", "H2O", "HOH", "OH2", "OP3", "OPC",  "OPC3", "SOL",   "SPC",  "SPCE",  "SPE",  "SW4",   "SW6", "SWM", "SWM4", "SWM6",
     "T3P", "T4E", "T4P", "T5P", "TIP", "TIP2", "TIP3", "TIP3P", "TIP4", "TIP4P", "TIP5", "TIP5P", "TP3", "TP4", "TP5",  "WAT"});
constexpr auto amino_acids = std::to_array<std::string_view>(
    {"ACE", "AIB", "ALA",  "ARG",  "ARGN", "ARN",  "ASH",  "ASN",  "ASP",  "ASPH", "ASPP", "ASX", "CME", "CSO", "CYM",
     "CYN", "CYS", "CYS2", "CYSH", "CYX",  "FOR",  "GLH",  "GLN",  "GLU",  "GLUH", "GLUP", "GLX", "GLY", "HID", "HIE",
     "HIP", "HIS", "HIS1", "HISA", "HISB", "HISD", "HISE", "HISH", "HISP", "HSD",  "HSE",  "HSP", "HYP", "ILE", "KCX",
     "LEU", "LSN", "LYN",  "LYP",  "LYS",  "LYSH", "M3L",  "MET",  "MLY",  "MSE",  "NH2",  "NLE", "NMA", "NME", "ORN",
     "PCA", "PHE", "PRO",  "PTR",  "PYL",  "SEC",  "SEP",  "SER",  "THR",  "TPO",  "TRP",  "TYR", "VAL"});
constexpr auto nucleotides = std::to_array<std::string_view>(
    {"1MA", "2MG", "5MC", "5MU", "7MG", "A",   "ADE", "C",   "CYT", "DA", "DC", "DG", "DI", "DT",  "DU", "G",
     "GUA", "H2U", "I",   "M2G", "N",   "OMC", "OMG", "PSU", "RA",  "RC", "RG", "RU", "T",  "THY", "U",  "URA"});

// Symbols that are meant where nothing but a number follows, wherever the name begins: the chlorine of a ligand is often " CL1".
constexpr auto plain_symbols =
    std::to_array<std::string_view>({"BR", "CL", "CU", "FE", "IR", "MG", "MN", "NI", "PT", "SE", "SI", "ZN"});

static_assert(std::ranges::is_sorted(waters) && std::ranges::is_sorted(amino_acids) && std::ranges::is_sorted(nucleotides) &&
              std::ranges::is_sorted(plain_symbols));

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string_view letters_of(std::string_view text) {
    return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, is_letter) - text.begin()));
}

std::string upper_case(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), upper);
    return result;
}

template <typename Words>
bool holds(const Words& words, std::string_view word) {
    return std::ranges::binary_search(words, word);
}

bool is_equal(std::string_view a, std::string_view b) { return a.size() == b.size() && std::ranges::equal(a, b, {}, upper, upper); }

// A Drude particle has the name of its atom behind the D, deuterium that of a hydrogen.
bool is_drude_particle(std::string_view name) {
    const std::string of_atom = upper_case(letters_of(name.substr(1)));
    if (of_atom.empty()) return false;
    constexpr std::size_t letters_of_ion = 3;  // LIT, BAR
    return std::string_view("CFINOPS").find(of_atom[0]) != std::string_view::npos ||
           holds(plain_symbols, std::string_view(of_atom)) || (of_atom.size() == letters_of_ion && find_ion(of_atom) != nullptr);
}

const Element& known(const Element* element) { return element == nullptr ? unknown_element() : *element; }

// The element of an atom that is its whole residue; null for another atom.
const Element* element_of_ion(std::string_view name, std::string_view residue) {
    const std::string_view letters = letters_of(name);
    const std::string_view of_residue = letters_of(residue);
    if (name == "W" && residue == "W") return nullptr;  // MARTINI's bead of four waters, and no tungsten
    if (letters.empty() || of_residue.empty()) return nullptr;
    if (!is_equal(letters, of_residue) && !is_equal(of_residue, "ION")) {
        // SOD of the residue NA, as some force fields have it.
        const Element* element = letters.size() == 3 ? find_ion(letters) : nullptr;
        return element != nullptr && element == find_element(of_residue) ? element : nullptr;
    }
    // AMBER's types of sodium and chloride, and its residue of sodium.
    if (is_equal(letters, "IP") || is_equal(letters, "CIO")) return find_element("Na");
    if (is_equal(letters, "IM")) return find_element("Cl");
    return find_ion(letters);
}

// In amino acids, nucleotides and water. `name` does not begin with a digit.
const Element& element_of_organic(std::string_view name, bool water) {
    switch (upper(name[0])) {
        case 'H': return *find_element("H");
        case 'D': return is_drude_particle(name) ? virtual_site() : *find_element("D");
        case 'O': return water && is_equal(name, "OM") ? virtual_site() : *find_element("O");
        case 'S': return *find_element(is_equal(name, "SE") ? "Se" : "S");
        case 'C':
        case 'N':
        case 'P': return *find_element(name.substr(0, 1));
        case 'E':  // EP, EPW: extra points
        case 'L':  // LP1: lone pairs
        case 'M':  // MW: the site of four-point water; MCB1: masses of GROMACS's virtual hydrogens
        case 'Q':  // QB: pseudo-atoms of NMR
        case 'X': return virtual_site();
        default: return unknown_element();
    }
}

bool is_two_letter_symbol(std::string_view name) {
    const std::string_view letters = letters_of(name);
    if (letters.size() < 2) return false;
    const bool mixed_case = letters[0] == upper(letters[0]) && letters[1] != upper(letters[1]);
    return (mixed_case && find_element(letters.substr(0, 2)) != nullptr) ||
           (letters.size() == 2 && holds(plain_symbols, std::string_view(upper_case(letters))));
}

// Hydrogens are often called so, and other atoms of molecules; the elements are not met there.
bool is_met(std::string_view symbol) {
    constexpr auto unmet = std::to_array<std::string_view>(
        {"CF", "CM", "CN", "HE", "HF", "HO", "HS", "NE", "NH", "NO", "NP", "OG", "PA", "PM", "PO", "PU"});
    return !holds(unmet, std::string_view(upper_case(symbol)));
}

}  // namespace

bool may_be_guessed(std::string_view symbol, std::string_view residue) {
    if (symbol.size() != 2) return false;
    if (is_water(residue) || is_polymer(residue)) return !holds(plain_symbols, std::string_view(upper_case(symbol)));
    constexpr auto of_amino_acids = std::to_array<std::string_view>({"CA", "CD", "CE", "HE", "HG", "NE", "NH", "OG"});
    return residue == "UNK" && holds(of_amino_acids, std::string_view(upper_case(symbol)));
}

bool is_water(std::string_view residue) { return holds(waters, residue); }

bool is_polymer(std::string_view residue) {
    if (holds(amino_acids, residue)) return true;
    // AMBER marks the ends of chains: NALA and CALA, RA5 and DG3, DAN alone.
    if (residue.size() == 4 && (residue[0] == 'N' || residue[0] == 'C') && holds(amino_acids, residue.substr(1))) return true;
    if (holds(nucleotides, residue)) return true;
    const bool marked = residue.size() > 1 && std::string_view("35N").find(residue.back()) != std::string_view::npos;
    return marked && holds(nucleotides, residue.substr(0, residue.size() - 1));
}

bool is_ion(std::string_view name, std::string_view residue) { return element_of_ion(name, residue) != nullptr; }

const Element& dummy_in(std::string_view residue) {
    return residue == "UNX" || residue == "UNL" ? unknown_element() : virtual_site();
}

const Element& element_of_site(std::string_view label) {
    const std::string_view letters = letters_of(label);
    constexpr std::string_view water = "WAT";
    if (is_equal(letters.substr(0, water.size()), water)) {
        const bool is_hydrogen = letters.size() > water.size() && upper(letters[water.size()]) == 'H';
        return *find_element(is_hydrogen ? "H" : "O");
    }
    const char first = letters.empty() ? ' ' : upper(letters[0]);
    if (letters.size() == 1 && (first == 'M' || first == 'X')) return unknown_element();
    if (first == 'T') return known(letters.size() > 1 ? find_element(letters.substr(0, 2)) : nullptr);  // no crystal has tritium
    if (first == 'D' && !is_two_letter_symbol(label)) return *find_element("D");                        // nor Drude particles
    return element_of_name(label, "", NameColumns::unknown);
}

const Element& element_of_name(std::string_view name, std::string_view residue, NameColumns columns) {
    const std::string_view all = trimmed(name, " ");
    if (residue == "DUM") return virtual_site();  // what marks a membrane's planes
    if (const Element* ion = element_of_ion(all, residue)) return *ion;

    // Old files put the number of a hydrogen first, or its quotes: 1HB, 'H5'.
    const std::size_t begin = all.find_first_not_of("0123456789'\"*");
    if (begin == std::string_view::npos) return unknown_element();
    const std::string_view word = all.substr(begin);
    if (word == "W" && residue == "W") return unknown_element();
    const bool water = is_water(residue);
    if (water || is_polymer(residue)) return element_of_organic(word, water);

    if (is_dummy(word)) return dummy_in(residue);
    const bool is_symbol = is_two_letter_symbol(word);
    if (upper(word[0]) == 'D' && !is_symbol) return element_of_organic(word, false);
    const Element* one = find_element(word.substr(0, 1));
    const Element* two = find_element(word.substr(0, 2));
    if (is_symbol || one == nullptr) return known(two);
    // A name of four letters fills its columns, and its place says nothing.
    const bool begins_left = columns == NameColumns::aligned && name.size() == 4 && name[0] != ' ' && name[3] == ' ' && word == all;
    return begins_left && two != nullptr && is_met(two->symbol) ? *two : *one;
}

}  // namespace sphereview

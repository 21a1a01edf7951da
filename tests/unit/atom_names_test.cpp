// Elements of atoms that files only name, as programs write them.
#include "formats/atom_names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sphereview {

namespace {

// "" where it is unknown, "-" of what is no atom.
std::string symbol_of(std::string_view name, std::string_view residue, NameColumns columns) {
    const Element& element = element_of_name(name, residue, columns);
    return is_virtual(element) ? "-" : std::string(element.symbol);
}

struct NamedAtom {
    const char* name;
    const char* residue;
    const char* symbol;
};

void expect_symbols(NameColumns columns, const std::vector<NamedAtom>& atoms) {
    for (const auto& [name, residue, symbol] : atoms) {
        EXPECT_EQ(symbol_of(name, residue, columns), symbol) << "'" << name << "' of " << residue;
    }
}

const std::vector<NamedAtom> anywhere = {
    // amino acids, nucleotides and water hold no metal
    {"CA", "ALA", "C"},
    {"CD1", "LEU", "C"},
    {"CE", "MET", "C"},
    {"HG", "SER", "H"},
    {"HE2", "HSD", "H"},
    {"HO2'", "A", "H"},
    {"NH1", "ARG", "N"},
    {"ND2", "NASN", "N"},
    {"OG1", "THR", "O"},
    {"OXT", "CALA", "O"},
    {"SG", "CYX", "S"},
    {"SE", "MSE", "Se"},
    {"P", "DA5", "P"},
    {"O1P", "RU3", "O"},
    {"C5M", "DT", "C"},
    {"H5T", "DAN", "H"},
    {"CD", "GLUP", "C"},
    {"1HB", "ALA", "H"},
    {"2HG1", "VAL", "H"},
    {"1HH1", "ARG", "H"},
    {"'H5'", "DA", "H"},
    {"*HO2", "A", "H"},
    {"'H5'", "LIG", "H"},
    {"DB1", "ALA", "H"},
    {"DZ1", "LYS", "H"},
    {"DG", "SER", "H"},
    {"HH31", "ACE", "H"},
    {"DA", "GLY", "H"},
    {"D1", "DOD", "H"},
    {"DH11", "ARG", "H"},
    {"OH2", "TIP3", "O"},
    {"HW1", "SOL", "H"},
    {"AD1", "ASN", ""},
    // ions
    {"CA", "CA", "Ca"},
    {"ZN", "ZN2", "Zn"},
    {"K", "K+", "K"},
    {"Na+", "Na+", "Na"},
    {"Cl-", "Cl-", "Cl"},
    {"NA", "NA+", "Na"},
    {"CD", "CD", "Cd"},
    {"CD2", "CD2", "Cd"},
    {"HG", "HG", "Hg"},
    {"HO", "HO3", "Ho"},
    {"SOD", "SOD", "Na"},
    {"SOD", "NA", "Na"},
    {"SOD", "ION", "Na"},
    {"POT", "POT", "K"},
    {"CLA", "CLA", "Cl"},
    {"CES", "CES", "Cs"},
    {"CAL", "CAL", "Ca"},
    {"LIT", "LIT", "Li"},
    {"RUB", "RUB", "Rb"},
    {"BAR", "BAR", "Ba"},
    {"CAD", "CAD", "Cd"},
    {"CAD", "LIG", "C"},
    {"CL", "ION", "Cl"},
    {"IP", "IP", "Na"},
    {"IM", "IM", "Cl"},
    {"Na+", "CIO", "Na"},
    {"CIO", "CIO", "Na"},
    // what is no atom
    {"MW", "SOL", "-"},
    {"MW", "HOH", "-"},
    {"M", "TIP4", "-"},
    {"EPW", "WAT", "-"},
    {"EP1", "T5P", "-"},
    {"LP1", "SOL", "-"},
    {"LP2", "HOH", "-"},
    {"OM", "SWM4", "-"},
    {"DOH2", "SWM4", "-"},
    {"DCA", "ALA", "-"},
    {"DN", "ALA", "-"},
    {"MCB1", "ALA", "-"},
    {"QB", "ALA", "-"},
    {"LP1A", "HSD", "-"},
    {"LP1", "LIG", "-"},
    {"DC12", "LIG", "-"},
    {"DF1", "LIG", "-"},
    {"DMG", "MG", "-"},
    {"DLIT", "LIT", "-"},
    {"DRUB", "RUB", "-"},
    {"DZN", "ZN2", "-"},
    {"DBAR", "BAR", "-"},
    {"DBR1", "LIG", "-"},
    {"DCL1", "LIG", "-"},
    {"D1", "LIG", "H"},
    {"Bq", "LIG", "-"},
    {"X", "LIG", "-"},
    {"N", "DUM", "-"},
    {"X", "UNX", ""},
    // other molecules
    {"CL1", "LIG", "Cl"},
    {"Cl1", "LIG", "Cl"},
    {"BR", "LIG", "Br"},
    {"Zn", "XYZ", "Zn"},
    {"FE", "HEM", "Fe"},
    {"MG", "CLA", "Mg"},
    {"SI2", "LIG", "Si"},
    {"C1", "LIG", "C"},
    {"H2A", "POPC", "H"},
    {"O5'", "LIG", "O"},
    {"HO5'", "LIG", "H"},
    {"F1", "LIG", "F"},
    {"?", "UNX", ""},
    {"", "LIG", ""},
    {"12", "LIG", ""},
};

}  // namespace

TEST(AtomNames, TellElementsWhereverTheyBegin) { expect_symbols(NameColumns::unknown, anywhere); }

TEST(AtomNames, OfCrystalsAreLabelsOfTheirSites) {
    const std::vector<std::pair<const char*, const char*>> cases = {
        {"CaM2", "Ca"}, {"MgM1", "Mg"}, {"SiT1", "Si"}, {"AlT1o", "Al"}, {"O1", "O"},   {"OH", "O"},    {"Oh1", "O"},
        {"Ow", "O"},    {"Wat", "O"},   {"Wat1", "O"},  {"WatO1", "O"},  {"WAT2", "O"}, {"WatH1", "H"}, {"W1", "W"},
        {"FeM1", "Fe"}, {"T1", ""},     {"T", ""},      {"T1o", ""},     {"T(1)", ""},  {"Ti1", "Ti"},  {"TI1", "Ti"},
        {"Te2", "Te"},  {"M1", ""},     {"M(2)", ""},   {"X", ""},       {"A1", ""},    {"Xe1", "Xe"},  {"Mn1", "Mn"},
        {"D1", "H"},    {"DO1", "H"},   {"Dy1", "Dy"},  {"Fe2+", "Fe"},  {"ZN1", "Zn"}, {"Na(1)", "Na"}};
    for (const auto& [label, symbol] : cases) {
        EXPECT_EQ(element_of_site(label).symbol, symbol) << label;
        EXPECT_FALSE(is_virtual(element_of_site(label))) << label;
    }
    EXPECT_TRUE(is_virtual(element_of_site("Bq1")));
}

TEST(AtomNames, OfOneElementDoNotDependOnTheirPlace) {
    for (const auto& [name, residue, symbol] : anywhere) {
        std::string columns = name;
        columns.resize(std::max<std::size_t>(columns.size(), 4), ' ');
        if (columns.size() == 4 && columns[3] == ' ') columns = " " + columns.substr(0, 3);
        EXPECT_EQ(symbol_of(columns, residue, NameColumns::aligned), symbol) << "'" << columns << "' of " << residue;
    }
}

TEST(AtomNames, TellElementsByTheirPlaceWhereTheFileHeedsIt) {
    expect_symbols(NameColumns::aligned, {
                                             {" NA ", "HEM", "N"},
                                             {"NA  ", "LIG", "Na"},
                                             {" CO ", "LIG", "C"},
                                             {"CO  ", "B12", "Co"},
                                             {" HG ", "LIG", "H"},
                                             {"HG  ", "MMC", "Hg"},
                                             {"CA1 ", "OEX", "Ca"},
                                             {"CA1 ", "ALA", "C"},
                                             {"CLA ", "LIG", "Cl"},
                                             {"HO  ", "LIG", "H"},
                                             {"NE  ", "LIG", "N"},
                                             {"C210", "POP", "C"},
                                             {"CA10", "LIG", "C"},
                                             {"CL10", "LIG", "Cl"},
                                             {" 1HA", "LIG", "H"},
                                             {"1HA ", "LIG", "H"},
                                             {"W   ", "LIG", "W"},
                                             {"W   ", "W", ""},  // MARTINI
                                         });
    expect_symbols(NameColumns::unknown, {{"NA", "LIG", "N"}, {"HG", "LIG", "H"}, {"CO", "LIG", "C"}});
}

TEST(AtomNames, TellKindsOfResidues) {
    for (const char* residue : {"HOH", "WAT", "SOL", "TIP3", "T4P", "SPCE", "DOD", "SWM4", "OPC"}) {
        EXPECT_TRUE(is_water(residue)) << residue;
        EXPECT_FALSE(is_polymer(residue)) << residue;
    }
    for (const char* residue : {"ALA", "VAL", "ACE", "NALA", "CVAL", "HSE", "CYS2", "A", "DG", "DG3", "RU5", "U", "URA", "PSU"}) {
        EXPECT_TRUE(is_polymer(residue)) << residue;
        EXPECT_FALSE(is_water(residue)) << residue;
    }
    for (const char* residue : {"", "LIG", "HEM", "CA", "XALA", "POPC", "ala"}) {
        EXPECT_FALSE(is_polymer(residue) || is_water(residue)) << residue;
    }
    EXPECT_TRUE(is_ion("CA", "CA"));
    EXPECT_FALSE(is_ion("CA", "ALA"));
    EXPECT_FALSE(is_ion("", ""));
}

}  // namespace sphereview

// PDB and mmCIF of programs that keep to less than the standards: no columns of elements, alternatives of any kind, sites that are
// no atoms.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "formats/elements.hpp"
#include "formats/sphere_data.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using Words = std::vector<std::string>;

SphereData read_programs_pdb(const std::string& text, const DataOptions& options = {}) { return read_pdb(text, "a.pdb", options); }

// The elements of the spheres: "" where it is unknown, "-" of what is no atom.
Words symbols_of(const Scene& scene) {
    Words symbols;
    for (const Sphere& sphere : scene.spheres) {
        std::string symbol = sphere.radius == virtual_site().radius ? "-" : "";
        for (int number = 1; number <= 118; ++number) {
            const Element& element = element_of_species(std::to_string(number));
            if (element.color == sphere.color && element.radius == sphere.radius) symbol = element.symbol;
        }
        symbols.push_back(symbol);
    }
    return symbols;
}

Words names_of_spheres(const Scene& scene) {
    Words names;
    for (const auto& [number, name] : scene.names) names.push_back(name);
    return names;
}

std::vector<double> xs_of(const Scene& scene) {
    std::vector<double> xs;
    for (const Sphere& sphere : scene.spheres) xs.push_back(sphere.center.x);
    return xs;
}

// A record with these first columns, up to the number of the residue, at x.
std::string record(std::string columns, double x, const std::string& rest = "  1.00  0.00") {
    columns.resize(30, ' ');
    std::string number = std::to_string(x).substr(0, 7);
    number.insert(0, 8 - number.size(), ' ');
    return columns + number + "   0.000   0.000" + rest + "\n";
}

}  // namespace

TEST(PdbOfPrograms, NamesMayAllBeginInTheirFirstColumn) {
    EXPECT_EQ(symbols_of(read_programs_pdb("ATOM      1 N    GLY A   1       0.000   0.000   0.000  1.00  0.00\n"
                                           "ATOM      2 CA   GLY A   1       1.450   0.000   0.000  1.00  0.00\n"
                                           "ATOM      3 HA1  GLY A   1       1.800   1.000   0.000  1.00  0.00\n"
                                           "ATOM      4 C    GLY A   1       2.000  -1.400   0.000  1.00  0.00\n"
                                           "ATOM      5 O    GLY A   1       3.200  -1.600   0.000  1.00  0.00\n")
                             .scene),
              (Words{"N", "C", "H", "C", "O"}));
    // Of a ligand alone no residue tells.
    EXPECT_EQ(symbols_of(read_programs_pdb(record("HETATM    1 CA   LIG A   1", 0) + record("HETATM    2 HG   LIG A   1", 1) +
                                           record("HETATM    3 CL1  LIG A   1", 2) + record("HETATM    4 CA    CA A   2", 3))
                             .scene),
              (Words{"C", "H", "Cl", "Ca"}));
    // The protein heeds the columns, the ligand of another program does not, and of the last one only the protein tells.
    EXPECT_EQ(symbols_of(read_programs_pdb(record("ATOM      1  CA  ALA A   1", 0) + record("HETATM    2 C1   LIG A   2", 1) +
                                           record("HETATM    3 CD   LIG A   2", 2) + record("HETATM    4 HG   MMC A   3", 3) +
                                           record("ATOM      5 SE   MSE A   4", 4))
                             .scene),
              (Words{"C", "C", "C", "Hg", "Se"}));
    // A single name that leaves the first column free shows that the file heeds it.
    EXPECT_EQ(
        symbols_of(read_programs_pdb(record("HETATM    1 CA   LIG A   1", 0) + record("HETATM    2  C1  LIG A   1", 1)).scene),
        (Words{"Ca", "C"}));
}

TEST(PdbOfPrograms, HydrogensMayBeginWithTheirNumber) {
    EXPECT_EQ(symbols_of(read_programs_pdb("ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00  0.00\n"
                                           "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00  0.00\n"
                                           "ATOM      3  1HA GLY A   1       1.800   1.000   0.000  1.00  0.00\n"
                                           "ATOM      4 2HA  GLY A   1       1.800  -1.000   0.000  1.00  0.00\n"
                                           "ATOM      5 HH31 ACE A   2       3.200  -1.600   0.000  1.00  0.00\n")
                             .scene),
              (Words{"N", "C", "H", "H", "H"}));
}

TEST(PdbOfPrograms, IonsOfCharmmAndResiduesOfFourLetters) {
    const SphereData data = read_programs_pdb(
        "ATOM      1 CLA  CLA  9251       0.000   0.000   0.000  0.00  0.00      ION\n"
        "ATOM      2 SOD  SOD  9267       3.000   0.000   0.000  0.00  0.00      ION\n"
        "ATOM      3 POT  POT  9268       6.000   0.000   0.000  0.00  0.00      ION\n"
        "ATOM      4  OH2 TIP3  269       9.000   0.000   0.000  0.00  0.00      WAT\n"
        "ATOM      5 FE   HEM   270      12.000   0.000   0.000  0.00  0.00      HEM\n"
        "ATOM      6  CL1 LIG   271      15.000   0.000   0.000  0.00  0.00      LIG\n"
        "ATOM      7 BR   LIG   271      18.000   0.000   0.000  0.00  0.00      LIG\n"
        "ATOM      8  MW  SOL   272      21.000   0.000   0.000  0.00  0.00      SOL\n");
    EXPECT_EQ(symbols_of(data.scene), (Words{"Cl", "Na", "K", "O", "Fe", "Cl", "Br", "-"}));
    EXPECT_EQ(data.scene.names.at(3), "TIP3 269/OH2");
    EXPECT_EQ(data.warnings,
              (Words{"a.pdb: found 1 virtual site or dummy, which is no atom; shown small, or not with --no-virtual"}));
    const auto name = [](const std::string& columns) { return read_programs_pdb(record(columns, 0)).scene.names.at(0); };
    EXPECT_EQ(name("ATOM      1  OH2 TIP3W   5"), "W/TIP3 5/OH2");
    EXPECT_EQ(name("ATOM      1  CA  ALAAB   5"), "AB/ALA 5/CA");
    EXPECT_EQ(name("ATOM      1  CA  ALA A12345"), "A/ALA 12345/CA");
}

// As VMD and CHARMM-GUI write them: all four columns of the residue, and the chain or a fifth digit right behind.
TEST(PdbOfPrograms, ResiduesOfFourLettersMayTouchTheirChain) {
    const auto names = [](const std::vector<std::string>& lines) {
        std::string text;
        for (const std::string& columns : lines) text += record(columns, 0);
        return names_of_spheres(read_programs_pdb(text).scene);
    };
    const std::string lipid = "ATOM      1  N   POPCM   1";
    EXPECT_EQ(names({lipid, "ATOM      2  N   POPEM   2", "ATOM      3  N   ALA M   3"}),
              (Words{"M/POPC 1/N", "M/POPE 2/N", "M/ALA 3/N"}));
    EXPECT_EQ(names({"ATOM      1  N   POPC10000", "ATOM      2  OH2 TIP312345"}), (Words{"POPC 10000/N", "TIP3 12345/OH2"}));
    // AMBER's ends of chains.
    EXPECT_EQ(names({"ATOM      1  N   NALAA   1"}), (Words{"A/NALA 1/N"}));
    // Chains of two letters show where residues have three or less.
    EXPECT_EQ(names({lipid, "ATOM      2  CA  ALACM   2"}), (Words{"CM/POP 1/N", "CM/ALA 2/CA"}));
    EXPECT_EQ(names({lipid, "ATOM      2  P    DACM   2"}), (Words{"CM/POP 1/N", "CM/DA 2/P"}));
}

TEST(PdbOfPrograms, SitesThatAreNoAtomsHideNone) {
    const std::string water =
        "ATOM      1  OW  SOL A   1       0.000   0.000   0.000  1.00  0.00\n"
        "ATOM      2  HW1 SOL A   1       0.957   0.000   0.000  1.00  0.00\n"
        "ATOM      3  HW2 SOL A   1      -0.240   0.926   0.000  1.00  0.00\n"
        "ATOM      4  MW  SOL A   1       0.093   0.120   0.000  1.00  0.00\n";
    EXPECT_EQ(symbols_of(read_programs_pdb(water).scene), (Words{"O", "H", "H", "-"}));
    const SphereData without = read_programs_pdb(water, {.virtual_sites = false});
    EXPECT_EQ(symbols_of(without.scene), (Words{"O", "H", "H"}));
    EXPECT_EQ(names_of_spheres(without.scene), (Words{"A/SOL 1/OW", "A/SOL 1/HW1", "A/SOL 1/HW2"}));
    EXPECT_EQ(without.warnings, (Words{"a.pdb: found 1 virtual site or dummy, which is no atom; left out"}));
    EXPECT_EQ(read_programs_pdb(water, {.radius = 2.0}).scene.spheres.at(3).radius, virtual_site().radius);
    EXPECT_EQ(read_programs_pdb(water, {.radius = 0.1}).scene.spheres.at(3).radius, 0.1);
    // The columns of elements may say it, and a residue that marks a membrane's planes, whatever its atoms are called.
    const SphereData data = read_programs_pdb(record("HETATM    1  X1  LIG A   1", 0, "  1.00  0.00           X") +
                                              record("HETATM    2  N   DUM  2031", 1, "  1.00  0.00           N") +
                                              record("HETATM    3  M   HOH A   2", 2, "  1.00  0.00          EP") +
                                              record("HETATM    4  X   UNX A   3", 3, "  1.00  0.00           X"));
    EXPECT_EQ(symbols_of(data.scene), (Words{"-", "-", "-", ""}));
    EXPECT_EQ(data.warnings,
              (Words{"a.pdb: found 3 virtual sites or dummies, which are no atoms; shown small, or not with --no-virtual"}));
}

TEST(PdbOfPrograms, ColumnsOfElementsMayHoldSomethingElse) {
    // The name of the entry and the number of the line, as before 1996; a symbol that is half of the name.
    EXPECT_EQ(symbols_of(read_programs_pdb(record("ATOM      1  CA  GLY     1", 0, "  1.00  0.00      1ABC  70") +
                                           record("ATOM      2  CA  GLY     1", 1, "  1.00  0.00          CA") +
                                           record("ATOM      3  CA  LIG     2", 2, "  1.00  0.00           c") +
                                           record("ATOM      4 SE   MSE     3", 3, "  1.00  0.00          SE") +
                                           record("ATOM      5  ZN  ABC     3", 3, "  1.00  0.00          ZN2+"))
                             .scene),
              (Words{"C", "C", "C", "Se", "Zn"}));
}

// PyMOL and others call the residue of any molecule UNK, which is also an amino acid of which nobody knows more.
TEST(PdbOfPrograms, ResiduesOfAnyMoleculeHoldAnyElement) {
    const std::string c = "  1.00  0.00           C";
    const auto symbols = [&](const std::string& columns, const std::string& element) {
        return symbols_of(read_programs_pdb(record("HETATM    1  C1  UNK     0", 0, c) +
                                            record("HETATM    2 " + columns, 3, "  1.00  0.00          " + element))
                              .scene)[1];
    };
    EXPECT_EQ(symbols("CL1  UNK     0", "CL"), "Cl");
    EXPECT_EQ(symbols("CL1  UNK     0", "  "), "Cl");
    EXPECT_EQ(symbols("BR2  UNK     0", "  "), "Br");
    EXPECT_EQ(symbols("PD1  UNK     0", "PD"), "Pd");
    EXPECT_EQ(symbols(" CA  UNK     0", "CA"), "C");
    EXPECT_EQ(symbols("CA   UNK     0", "CA"), "Ca");
    EXPECT_EQ(symbols("BR     U A   3", "BR"), "Br");
    EXPECT_EQ(symbols(" CA  ALA A   3", "CA"), "C");
}

TEST(PdbOfPrograms, AlternativesAreChosenByGroupAndCompleted) {
    EXPECT_EQ(names_of_spheres(read_programs_pdb("ATOM      1  N   LYS A   1       0.000   0.000   0.000  1.00  0.00           N\n"
                                                 "ATOM      2  CG ALYS A   1       1.000   0.000   0.000  0.30  0.00           C\n"
                                                 "ATOM      3  CG BLYS A   1       1.100   0.000   0.000  0.70  0.00           C\n"
                                                 "ATOM      4  NZ ALYS A   1       3.000   0.000   0.000  0.30  0.00           N\n")
                                   .scene),
              (Words{"A/LYS 1/N", "A/LYS 1/CG", "A/LYS 1/NZ"}));
    EXPECT_EQ(xs_of(read_programs_pdb("ATOM      1  N   SER A   1       0.000   0.000   0.000  1.00  0.00           N\n"
                                      "ATOM      2  CA ASER A   1       1.000   0.000   0.000  0.60  0.00           C\n"
                                      "ATOM      3  CA BSER A   1       1.100   0.000   0.000  0.40  0.00           C\n"
                                      "ATOM      4  CB  SER A   1       2.000   0.000   0.000  1.00  0.00           C\n"
                                      "ATOM      5  OG CSER A   1       3.000   0.000   0.000  0.55  0.00           O\n"
                                      "ATOM      6  OG DSER A   1       3.000   1.000   0.000  0.45  0.00           O\n")
                        .scene),
              (std::vector<double>{0, 1, 2, 3}));
}

TEST(PdbOfPrograms, AlternativesMayStandApartAndBeOtherResidues) {
    const auto at = [](const std::string& columns, double x, const char* occupancy) {
        return record(columns, x, std::string("  ") + occupancy + "  0.00");
    };
    // The second places of all residues behind the first ones.
    EXPECT_EQ(xs_of(read_programs_pdb(at("ATOM      1  CA AALA A   1", 0, "0.60") + at("ATOM      2  CA AVAL A   2", 1, "0.40") +
                                      at("ATOM      3  CA BALA A   1", 2, "0.40") + at("ATOM      4  CA BVAL A   2", 3, "0.60"))
                        .scene),
              (std::vector<double>{0, 3}));
    // Two residues share a place: nothing of the other one completes that which is chosen.
    EXPECT_EQ(xs_of(read_programs_pdb(at("ATOM      1  CA ASER A   1", 0, "0.60") + at("ATOM      2  CA BPRO A   1", 1, "0.40") +
                                      at("ATOM      3  OG ASER A   1", 2, "0.60") + at("ATOM      4  CD BPRO A   1", 3, "0.40"))
                        .scene),
              (std::vector<double>{0, 2}));
    // Waters that are counted from 1 again are no places of the residue 1, whose oxygen has their name.
    EXPECT_EQ(xs_of(read_programs_pdb(at("ATOM      1  O  AALA A   1", 0, "0.60") + at("ATOM      2  O  BALA A   1", 1, "0.40") +
                                      at("ATOM      3  N   VAL A   2", 2, "1.00") + at("HETATM    4  O  AHOH A   1", 3, "0.30") +
                                      at("HETATM    5  O  BHOH A   1", 4, "0.70"))
                        .scene),
              (std::vector<double>{0, 2, 4}));
    // Two waters without numbers are two.
    EXPECT_EQ(xs_of(read_programs_pdb(at("HETATM    1  O  AHOH A", 0, "0.50") + at("HETATM    2  O  BHOH A", 9, "0.60")).scene),
              (std::vector<double>{0, 9}));
    // Atoms that an alternative has twice are two.
    EXPECT_EQ(xs_of(read_programs_pdb(at("HETATM    1  H  ALIG A   1", 0, "0.50") + at("HETATM    2  H  ALIG A   1", 1, "0.50") +
                                      at("HETATM    3  H  BLIG A   1", 2, "0.40"))
                        .scene),
              (std::vector<double>{0, 1}));
}

TEST(PdbOfPrograms, VirtualSitesOfPlacesThatAreNotKeptDoNotCount) {
    const std::string text =
        record("HETATM    1  MW ASOL A   1", 0) + record("HETATM    2  MW BSOL A   1", 1) + record("HETATM    3  OW  SOL A   1", 2);
    EXPECT_EQ(xs_of(read_programs_pdb(text).scene), (std::vector<double>{0, 2}));
    EXPECT_EQ(read_programs_pdb(text).warnings.at(0).find("a.pdb: found 1 virtual site"), 0U);
    EXPECT_EQ(xs_of(read_programs_pdb(text, {.virtual_sites = false}).scene), (std::vector<double>{2}));
}

// What stands behind the wanted model is not looked at, but for half a line at the end.
TEST(PdbOfPrograms, ALastModelMayBeCutShort) {
    const std::string text =
        "MODEL        1\n" + record("ATOM      1  CA  ALA A   1", 0) + "ENDMDL\nMODEL        2\nATOM      1  CA  AL";
    const SphereData cut = read_programs_pdb(text);
    EXPECT_EQ(cut.frames, 1);
    EXPECT_EQ(xs_of(cut.scene), (std::vector<double>{0}));
    EXPECT_EQ(cut.warnings, (Words{"a.pdb:5:20: the line ends, expected the atom's x in columns 31 to 38; what follows frame 0 is "
                                   "passed over"}));
    EXPECT_EQ(message_of<InputError>([&] { read_programs_pdb(text, {.frame = 1}); }),
              "a.pdb:5:20: the line ends, expected the atom's x in columns 31 to 38");
    // A whole line needs no end.
    std::string whole = record("ATOM      1  CA  ALA A   1", 0) + "END\n" + record("ATOM      1  CA  ALA A   1", 1);
    whole.pop_back();
    EXPECT_EQ(read_programs_pdb(whole).frames, 2);
    EXPECT_TRUE(read_programs_pdb(whole).warnings.empty());
}

TEST(PdbOfPrograms, ALastModelMayBeCutBehindAWholeLine) {
    const std::string atom = record("ATOM      1  CA  ALA A   1", 0);
    const std::string first = "MODEL        1\n" + atom + "ENDMDL\n";
    std::string without_line_end = first + "MODEL        2\n" + atom;
    without_line_end.pop_back();
    const std::vector<std::pair<std::string, std::string>> cuts = {
        {first + "MODEL   ", "4:9"},
        {first + "MODEL        2\n", "5:1"},
        {without_line_end, "5:" + std::to_string(atom.size())},
        {first + "MODEL        2\n" + atom + "TER\n", "7:1"},
        {first + "MODEL        2\n" + atom + "END", ""},
        {first + "MODEL        2\n" + atom + "CONECT    1    2\n", ""},
        {first + "MODEL        2\n" + atom + "ENDMDL", ""},
        {"MODEL        1\n" + atom + "MODEL        2\n" + atom, ""},  // no model has an end
    };
    for (const auto& [text, place] : cuts) {
        const SphereData data = read_programs_pdb(text);
        EXPECT_EQ(data.scene.spheres.size(), 1U) << text;
        if (place.empty()) {
            EXPECT_EQ(data.frames, 2) << text;
            EXPECT_EQ(data.warnings, Words()) << text;
            EXPECT_EQ(read_programs_pdb(text, {.frame = 1}).warnings, Words()) << text;
            continue;
        }
        const std::string fault = "a.pdb:" + place + ": the text ends, expected ENDMDL of frame 1";
        EXPECT_EQ(data.frames, 1) << text;
        EXPECT_EQ(data.fault, fault);
        EXPECT_EQ(data.warnings, Words{fault + "; what follows frame 0 is passed over"});
        for (const PartOfFile& part :
             {PartOfFile{}, PartOfFile{.stops = true}, PartOfFile{.frames = 1, .begin = first.size(), .stops = true}})
            EXPECT_EQ(message_of<InputError>([&] { read_programs_pdb(text, {.frame = 1, .part = part}); }), fault);
    }
    const SphereData only = read_programs_pdb("MODEL        1\n" + atom);
    EXPECT_EQ(only.frames, 1);
    EXPECT_EQ(only.scene.spheres.size(), 1U);
    EXPECT_EQ(only.warnings, Words{"a.pdb:3:1: the text ends, expected ENDMDL of frame 0"});
}

// As where a run goes on that was ended while it wrote.
TEST(PdbOfPrograms, AModelMayBeCutBeforeTheNext) {
    const std::string atom = record("ATOM      1  CA  ALA A   1", 0);
    const std::string whole = "MODEL        1\n" + atom + atom + "ENDMDL\n";
    const std::string cut = "MODEL        2\n" + atom;
    const auto warning = [](int line, int frame) {
        const std::string number = std::to_string(frame);
        return Words{"a.pdb:" + std::to_string(line) + ":1: found 'MODEL', expected ENDMDL of frame " + number +
                     " above it; frame " + number + " may be cut off"};
    };
    const std::string text = whole + cut + whole;
    EXPECT_EQ(read_programs_pdb(text).frames, 3);
    EXPECT_EQ(read_programs_pdb(text).warnings, warning(7, 1));
    const DataOptions second{.frame = 1, .part = {.frames = 1, .begin = whole.size(), .stops = true}};
    EXPECT_EQ(read_programs_pdb(text, second).warnings, warning(7, 1));
    EXPECT_EQ(read_programs_pdb(text, second).scene.spheres.size(), 1U);
    EXPECT_EQ(read_programs_pdb(cut + whole + whole).warnings, warning(3, 0));
}

#ifndef WITHOUT_GEMMI
TEST(MmcifOfPrograms, ElementsAreGuessedWithoutTypeSymbol) {
    const std::string text =
        "data_own\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
        "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "ATOM 1 CA GLY A 1 0 0 0\nATOM 2 HA2 GLY A 1 1 0 0\nHETATM 3 CA CA A 2 5 0 0\nATOM 4 \"O5'\" DA A 3 8 0 0\n"
        "HETATM 5 MW HOH A 4 9 0 0\n";
    const SphereData data = read_mmcif(text, "a.cif", {});
    EXPECT_EQ(symbols_of(data.scene), (Words{"C", "H", "Ca", "O", "-"}));
    EXPECT_EQ(data.warnings,
              (Words{"a.cif: found 1 virtual site or dummy, which is no atom; shown small, or not with --no-virtual"}));
    EXPECT_EQ(symbols_of(read_mmcif(text, "a.cif", {.virtual_sites = false}).scene), (Words{"C", "H", "Ca", "O"}));
}

TEST(MmcifOfPrograms, TwoWatersWithoutNumbersAreTwo) {
    const std::string columns =
        "data_own\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n";
    EXPECT_EQ(
        xs_of(read_mmcif(columns + "HETATM 1 O O A HOH B . 0 0 0 0.5\nHETATM 2 O O B HOH B . 9 0 0 0.6\n", "a.cif", {}).scene),
        (std::vector<double>{0, 9}));
    EXPECT_EQ(xs_of(read_mmcif(columns + "ATOM 1 C CG A LYS A 1 0 0 0 0.3\nATOM 2 C CG B LYS A 1 1 0 0 nan\n"
                                         "ATOM 3 N NZ A LYS A 1 2 0 0 0.3\n",
                               "a.cif", {})
                        .scene),
              (std::vector<double>{1, 2}));
}

TEST(MmcifOfPrograms, ALastModelMayBeCutShort) {
    const std::string columns =
        "data_own\nloop_\n_atom_site.pdbx_PDB_model_num\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    const std::string text = columns + "1 0 0 0\n1 1 0 0\n2 2 0 0\n2 3 0";
    const SphereData data = read_mmcif(text, "a.cif", {});
    EXPECT_EQ(data.frames, 1);
    EXPECT_EQ(xs_of(data.scene), (std::vector<double>{0, 1}));
    ASSERT_EQ(data.warnings.size(), 1U);
    EXPECT_TRUE(data.warnings[0].starts_with("a.cif:2")) << data.warnings[0];
    EXPECT_TRUE(data.warnings[0].ends_with("; what follows frame 0 is passed over")) << data.warnings[0];
    EXPECT_EQ(read_mmcif(text, "a.cif", {.part = {.stops = true}}).warnings, Words()) << "they are said where frames are counted";
    EXPECT_THROW(read_mmcif(text, "a.cif", {.frame = 1}), InputError);
    EXPECT_THROW(read_mmcif(columns + "1 0 0 0\n1 1 0", "a.cif", {}), InputError);
    EXPECT_THROW(read_mmcif(columns + "1 0 0 0\n2 1 0\n2 1", "a.cif", {}), InputError);
}
#endif

}  // namespace sphereview

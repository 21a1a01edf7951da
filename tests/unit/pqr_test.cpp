// PQR.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "scene/property.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

SphereData pqr(const std::string& text, const DataOptions& options = {}) { return read_pqr(text, "a.pqr", options); }

const std::string pqr_two =
    "ATOM      1  N   LEU     1       3.326  25.010  35.700 -0.3000 1.8500\n"
    "ATOM      2  CA  LEU     1       4.326  25.010  35.700  0.2100 2.2750\n";

}  // namespace

TEST(Pqr, HasItsOwnRadii) {
    const SphereData data = pqr(pqr_two);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0], (Sphere{{3.326, 25.01, 35.7}, 1.85, find_element("N")->color, false}));
    EXPECT_EQ(data.scene.spheres[1], (Sphere{{4.326, 25.01, 35.7}, 2.275, find_element("C")->color, false}));
    EXPECT_EQ(data.scene.names.at(1), "LEU 1/CA");
    EXPECT_TRUE(data.warnings.empty());
    EXPECT_EQ(format_of_name("a.pqr").name, "PQR");
}

TEST(Pqr, IsKnownWithoutAName) {
    const auto format = [](const std::string& text) { return detect_format(text, "stdin").name; };
    for (const std::string head : {"", "REMARK   1 PQR file\nREMARK\n", "# by hand\n\nCRYST1 9 9 9\nMODEL 1\n"}) {
        EXPECT_EQ(format(head + pqr_two), "PQR") << head;
    }
    const std::string place = "ATOM      1  N   LEU A   1       3.326  25.010  35.700";
    const std::string pdb = place + "  1.00 18.50\n";
    EXPECT_EQ(format(place + " -0.30  1.85\n"), "PQR");
    EXPECT_EQ(format(place + "  0.30  1.85\n" + place + " -0.30  1.85\n"), "PQR");
    EXPECT_EQ(format("ATOM 1 N LEU 1 1.0 2.0 3.0 0.5 1.8\n"), "PQR");
    EXPECT_EQ(format("HETATM 1 N LEU A 1 1.0 2.0 3.0 0 1.8\n"), "PQR");
    EXPECT_EQ(format("ATOM 1 N LEU 1 1.0 2.0 3.0 -0.50 1.80\r\n"), "PQR");
    // A PDB without elements ends with an occupancy and a factor, or with less.
    EXPECT_EQ(format(pdb), "PDB");
    EXPECT_EQ(format(pdb + pqr_two.substr(0, 20)), "PDB");
    EXPECT_EQ(format(place + "  1.00\n"), "PDB");
    EXPECT_EQ(format(place + "\n"), "PDB");
    EXPECT_EQ(format(place + " -1.00 18.50           N\n"), "PDB");
    EXPECT_EQ(format("ATOM      1  N   LEU 1   1       3.326  25.010  35.700  1.00\n"), "PDB");
    // One that is not in its columns may be either.
    const std::string either = "ATOM 1 N LEU A 1 1.0 2.0 3.0 1.00 1.80\n";
    EXPECT_EQ(format(either), "PDB");
    const std::string said = message_of<InputError>([&] { read_pdb(either, "stdin", {}); });
    EXPECT_TRUE(said.ends_with("; a PQR is known by a name that ends with .pqr")) << said;
    EXPECT_EQ(message_of<InputError>([&] { read_pdb(place.substr(0, 40) + "\n", "stdin", {}); }),
              "stdin:1:41: the line ends, expected the atom's y in columns 39 to 46");
}

TEST(Pqr, ReadsWhatProgramsWrite) {
    EXPECT_EQ(pqr("ATOM 1 N LEU A 12 1 2 3 -0.3 1.8\n").scene.names.at(0), "A/LEU 12/N");
    EXPECT_EQ(pqr("ATOM 1 N LEU 12B 1 2 3 -0.3 1.8\n").scene.names.at(0), "LEU 12B/N");
    EXPECT_EQ(pqr("ATOM 1 N LEU 7 1 2 3 -0.3 1.8 N\r\n").scene.spheres.at(0).radius, 1.8);
    EXPECT_EQ(pqr("ATOM 1 N LEU A 7 1 2 3 -0.3 1.8 N\n").scene.spheres.at(0).radius, 1.8);
    EXPECT_EQ(pqr("HETATM 1 CA CA 7 1 2 3 2.0 1.7\n").scene.spheres.at(0).color, find_element("Ca")->color);
    // A radius of 0, as some force fields give hydrogens, is the usual one.
    EXPECT_EQ(pqr("ATOM 1 HO SER 7 1 2 3 0.4 0.0\n").scene.spheres.at(0).radius, find_element("H")->radius);
    EXPECT_EQ(pqr("ATOM 1 HO SER 7 1 2 3 0.4 0.0\n", {.radius = 0.7}).scene.spheres.at(0).radius, 0.7);
    EXPECT_EQ(pqr(pqr_two + "TER\nEND\n" + pqr_two).frames, 2);
}

// PDB2PQR's columns leave no blank where a field is full.
TEST(Pqr, FieldsMayTouch) {
    const auto first = [](const std::string& line) {
        const Scene scene = pqr(line + "\n").scene;
        std::string symbol;
        for (const char* known : {"H", "C", "N", "O", "Cl", "Zn"}) {
            if (scene.spheres.at(0).color == find_element(known)->color) symbol = known;
        }
        return symbol + " " + scene.names.at(0);
    };
    EXPECT_EQ(first("HETATM10000  CL  CL  A   1       1.000   2.000   3.000 -1.0000 1.9000"), "Cl A/CL 1/CL");
    EXPECT_EQ(first("HETATM10001 ZN   ZN  A   1       1.000   2.000   3.000  2.0000 1.9000"), "Zn A/ZN 1/ZN");
    EXPECT_EQ(first("HETATM10002  O   HOH A 501       3.000   0.000   0.000 -0.8000 1.7000"), "O A/HOH 501/O");
    EXPECT_EQ(first("HETATM10003  C1  LIG     1       1.000   2.000   3.000  0.1000 1.9000"), "C LIG 1/C1");
    EXPECT_EQ(first("ATOM  99999  N   ALA A1000       1.000   2.000   3.000  0.1000 1.9000"), "N A/ALA 1000/N");
    EXPECT_EQ(first("ATOM      1  N   POPCM   1       1.000   2.000   3.000  0.1000 1.9000"), "N M/POPC 1/N");
    EXPECT_EQ(first("ATOM      1 HN11TIP3 A   1       1.000   2.000   3.000  0.1000 1.9000"), "H A/TIP3 1/HN11");
    EXPECT_EQ(first("ATOM      1 HH11AARG A   1       1.000   2.000   3.000  0.1000 1.9000"), "H A/ARG 1/HH11");
    EXPECT_EQ(first("ATOM      1 HH11NARG A   1       1.000   2.000   3.000  0.1000 1.9000"), "H A/NARG 1/HH11");
    EXPECT_EQ(first("ATOM 1 N ALA A1000 1 2 3 0.1 1.9"), "N A/ALA 1000/N");
    const auto sphere = [](const std::string& line) { return pqr(line + "\n").scene.spheres.at(0); };
    const Sphere far = sphere("ATOM      1  N   LEU     1    -103.326-125.010-135.700 -0.3000 1.8500");
    EXPECT_EQ(far, (Sphere{{-103.326, -125.01, -135.7}, 1.85, find_element("N")->color, false}));
    EXPECT_EQ(sphere("ATOM      1  N   LEU A   1    1103.3261125.0101135.700-10.300010.8500"),
              (Sphere{{1103.326, 1125.01, 1135.7}, 10.85, find_element("N")->color, false}));
    EXPECT_EQ(sphere("ATOM 1 N LEU 1 -103.32-125.01-135.70 -0.3 1.85"),
              (Sphere{{-103.32, -125.01, -135.7}, 1.85, find_element("N")->color, false}));
}

TEST(VirtualSites, AreSmallWhateverRadiusTheFileGives) {
    const std::string text = "ATOM 1 O WAT 1 0 0 0 -0.8 1.7\nATOM 2 EPW WAT 1 0.1 0 0 -0.8 1.7\n";
    EXPECT_EQ(pqr(text).scene.spheres.at(0).radius, 1.7);
    EXPECT_EQ(pqr(text).scene.spheres.at(1).radius, virtual_site().radius);
    // Never larger than an atom, whatever the unit is.
    EXPECT_EQ(pqr("ATOM 1 O WAT 1 0 0 0 -0.8 0.07\nATOM 2 EPW WAT 1 0 0 0 -0.8 0.17\n").scene.spheres.at(1).radius, 0.07);
    EXPECT_EQ(pqr("ATOM 1 O WAT 1 0 0 0 -0.8 0.07\nATOM 2 EPW WAT 1 0 0 0 -0.8 0.01\n").scene.spheres.at(1).radius, 0.01);
    const Scene extended = read_xyz("2\nProperties=species:S:1:pos:R:3:radius:R:1\nX 0 0 0 5\nO 1 0 0 .6\n", "a.xyz", {}).scene;
    EXPECT_EQ(extended.spheres.at(0).radius, virtual_site().radius);
    EXPECT_EQ(extended.spheres.at(1).radius, 0.6);
    const SphereData without = pqr(text, {.virtual_sites = false, .all_properties = true});
    EXPECT_EQ(without.scene.spheres.size(), 1U);
    EXPECT_EQ(size_of(without.scene.properties.at(0)), 1U);
}

TEST(Pqr, ALastLineMayBeCutShort) {
    const std::string model = "MODEL 1\n" + pqr_two + "ENDMDL\n";
    const SphereData cut = pqr(model + "MODEL 2\nATOM 1 N ALA 1 1 0 0 ");
    EXPECT_EQ(cut.frames, 1);
    EXPECT_EQ(
        cut.warnings,
        (std::vector<std::string>{"a.pqr:6:22: the line ends, expected the atom's charge; what follows frame 0 is passed over"}));
    const SphereData without_end = pqr(model + "MODEL 2\n" + pqr_two.substr(0, pqr_two.size() - 3));
    EXPECT_EQ(without_end.frames, 1);
    EXPECT_EQ(
        without_end.warnings,
        (std::vector<std::string>{"a.pqr:7:68: the text ends, expected ENDMDL of frame 1; what follows frame 0 is passed over"}));
    // Half a radius is a radius, too.
    const SphereData half = pqr(model + "REMARK\n" + pqr_two.substr(0, pqr_two.size() - 3), {.frame = 1});
    EXPECT_EQ(half.scene.spheres.size(), 2U);
    EXPECT_EQ(half.warnings,
              (std::vector<std::string>{
                  "a.pqr:7:68: the line ends before that of the atom above it, expected the whole of the atom's radius"}));
    for (const std::string& whole : {pqr_two.substr(0, pqr_two.size() - 1), model + pqr_two.substr(0, pqr_two.size() - 1),
                                     std::string("ATOM 1 N LEU 7 1 2 3 -0.3 1.85\nATOM 1 N LEU 7 1 2 3 -0.3 1.8")}) {
        for (std::int64_t frame = 0; frame < pqr(whole).frames; ++frame) EXPECT_TRUE(pqr(whole, {.frame = frame}).warnings.empty());
    }
}

TEST(PqrErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { pqr(text); };
    expect_messages("a.pqr", read,
                    {
                        {"", "1:1: the text is empty, expected a record ATOM or HETATM"},
                        {"REMARK\n", "2:1: the text ends, expected a record ATOM or HETATM"},
                        {"ATOM\n", "1:5: the line ends, expected the atom's x"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3\n", "1:26: the line ends, expected the atom's radius"},
                        {"ATOM 1 N LEU A 7 0 0 0 0.1\n", "1:27: the line ends, expected the atom's radius"},
                        {"ATOM 1 N LEU 7 1 two 3 -0.3 1.8\n", "1:18: found 'two', expected the atom's y, a number"},
                        {"ATOM 1 N LEU 7 1 2 inf -0.3 1.8\n", "1:20: found 'inf', expected the atom's z, a finite number"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3 -1.8\n", "1:27: found '-1.8', expected the atom's radius, 0 or above"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3 nan\n", "1:27: found 'nan', expected the atom's radius, a finite number"},
                    });
}

}  // namespace sphereview

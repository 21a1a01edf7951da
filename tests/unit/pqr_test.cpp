// PQR.
#include <gtest/gtest.h>

#include <string>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
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
    for (const std::string head : {"", "REMARK   1 PQR file\nREMARK\n"}) EXPECT_EQ(detect_format(head + pqr_two, "").name, "PQR");
    EXPECT_EQ(format_of_name("a.pqr").name, "PQR");
    // PDB without elements ends with an occupancy and a factor.
    EXPECT_EQ(detect_format("ATOM      1  N   LEU     1       3.326  25.010  35.700  1.00 18.50\n", "").name, "PDB");
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

TEST(PqrErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { pqr(text); };
    expect_messages("a.pqr", read,
                    {
                        {"", "1:1: the text is empty, expected a record ATOM or HETATM"},
                        {"REMARK\n", "2:1: the text ends, expected a record ATOM or HETATM"},
                        {"ATOM\n", "1:5: the line ends, expected the atom's x"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3\n", "1:26: the line ends, expected the atom's radius"},
                        {"ATOM 1 N LEU 7 1 two 3 -0.3 1.8\n", "1:18: found 'two', expected the atom's y, a number"},
                        {"ATOM 1 N LEU 7 1 2 inf -0.3 1.8\n", "1:20: found 'inf', expected the atom's z, a finite number"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3 -1.8\n", "1:27: found '-1.8', expected the atom's radius, 0 or above"},
                        {"ATOM 1 N LEU 7 1 2 3 -0.3 nan\n", "1:27: found 'nan', expected the atom's radius, a finite number"},
                    });
}

}  // namespace sphereview

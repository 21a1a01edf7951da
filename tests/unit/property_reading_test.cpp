// What the readers keep of each sphere beside place, size and colour.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "formats/scene_format.hpp"

namespace sphereview {

namespace {

using Words = std::vector<std::string>;

const DataOptions everything{.all_properties = true};

// The values of all spheres, as people read them, with blanks between.
std::string values(const SphereData& data, const std::string& name) {
    const Property* const property = find_property(data.scene.properties, name);
    if (property == nullptr) return "none";
    EXPECT_EQ(size_of(*property), data.scene.spheres.size());
    std::string text;
    for (std::size_t i = 0; i < size_of(*property); ++i) {
        const std::string value = text_at(*property, i);
        text += (i == 0 ? "" : " ") + (value.empty() ? "." : value);
    }
    return text;
}

Words names_of_kept(const SphereData& data) {
    Words names;
    for (const Property& property : data.scene.properties) names.push_back(property.name);
    return names;
}

const std::string extended_xyz =
    "3\nProperties=species:S:1:pos:R:3:q:R:1:tag:I:1:forces:R:3:fixed:L:1:mtt::aux:R:2\n"
    "C 0 0 0 0.5 1 3 4 0 T 1 2\nX 1 0 0 -1.5 2 0 0 1 F 3 4\n8 2 0 0 1D-1 3 0 0 2 F 5 6\n";

}  // namespace

TEST(PropertiesOfXyz, AreItsColumns) {
    const SphereData data = read_xyz(extended_xyz, "a", everything);
    const Words all = {"element", "q", "tag", "forces.x", "forces.y", "forces.z", "forces", "fixed", "mtt::aux.1", "mtt::aux.2"};
    EXPECT_EQ(data.property_names, all);
    EXPECT_EQ(names_of_kept(data), all);
    EXPECT_EQ(values(data, "element"), "C X O");
    EXPECT_EQ(values(data, "q"), "0.5 -1.5 0.1");
    EXPECT_EQ(values(data, "tag"), "1 2 3");
    EXPECT_EQ(values(data, "forces"), "5 1 2");
    EXPECT_EQ(values(data, "forces.y"), "4 0 0");
    EXPECT_EQ(values(data, "fixed"), "T F F");
    EXPECT_EQ(values(data, "mtt::aux.2"), "2 4 6");
    EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(find_property(data.scene.properties, "tag")->values));
}

TEST(PropertiesOfXyz, HaveOneElement) {
    const SphereData data = read_xyz("1\nProperties=species:S:1:pos:R:3:Z:I:1\nC 0 0 0 6\n", "a", everything);
    EXPECT_EQ(data.property_names, (Words{"element", "Z"}));
    EXPECT_EQ(values(data, "Z"), "6");
}

TEST(PropertiesOfXyz, AreKeptOnlyWhereAskedFor) {
    const SphereData none = read_xyz(extended_xyz, "a", {});
    EXPECT_TRUE(none.scene.properties.empty());
    EXPECT_EQ(none.property_names.size(), 10U);
    EXPECT_EQ(names_of_kept(read_xyz(extended_xyz, "a", {.properties = {"FORCES", "charge", "Q"}})), (Words{"q", "forces"}));
}

// A virtual site that is left out takes its values along.
TEST(PropertiesOfXyz, GoWithTheirSpheres) {
    const SphereData data = read_xyz(extended_xyz, "a", {.virtual_sites = false, .all_properties = true});
    EXPECT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(values(data, "element"), "C O");
    EXPECT_EQ(values(data, "tag"), "1 3");
}

TEST(PropertiesOfXyz, MayBeColumnsThatNothingNames) {
    const SphereData data = read_xyz("2\nqm9\nC 0 0 0 -0.5 7\nH 1 0 0 0.25 8\n0.1 0.2\n", "a", everything);
    EXPECT_EQ(data.property_names, (Words{"element", "column5", "column6"}));
    EXPECT_EQ(values(data, "column5"), "-0.5 0.25");
    EXPECT_EQ(values(data, "column6"), "7 8");
    EXPECT_EQ(read_xyz("1\n\nC 0 0 0 word\n", "a", {}).property_names, Words{"element"});
}

TEST(PropertiesOfCsv, AreAllThatIsNoPlaceColourOrName) {
    const std::string table =
        "x,y,z,radius,r,g,b,name,charge,n,class,Type,late\n"
        "0,0,0,1,1,2,3,a,0.5,1,\"one \"\"1\"\"\",1,1\n,,,,,,,skipped,9,9,9,9,9\n1,0,0,,1,2,3,b,NA,,two,2,word\n";
    const SphereData data = read_csv(table, "a.csv", everything);
    EXPECT_EQ(data.property_names, (Words{"radius", "charge", "n", "class", "Type", "late"}));
    EXPECT_EQ(values(data, "radius"), "1 .");
    EXPECT_EQ(values(data, "charge"), "0.5 .");
    EXPECT_EQ(values(data, "n"), "1 .");
    EXPECT_EQ(values(data, "class"), "one \"1\" two");
    EXPECT_EQ(values(data, "Type"), "1 2");
    EXPECT_TRUE(is_category(*find_property(data.scene.properties, "Type")));
    EXPECT_EQ(values(data, "late"), "1 word");
    const Property& whole = *find_property(data.scene.properties, "n");
    EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(whole.values));
}

TEST(PropertiesOfCsv, FollowItsHabits) {
    const SphereData commas = read_csv("x;y;z;q\n1,5;0;0;-0,25\n2,5;0;0;3000000000\n", "a.csv", everything);
    EXPECT_EQ(values(commas, "q"), "-0.25 3e+09");
    const SphereData bare = read_csv("0,0,0,0.5\n1,0,0,0.75\n", "a.csv", everything);
    EXPECT_EQ(bare.property_names, Words{"column4"});
    EXPECT_EQ(values(bare, "column4"), "0.5 0.75");
    const SphereData atoms = read_csv("element,x,y,z,m,m\nNa,0,0,0,1,2\nCL,1,0,0,3,4\n", "a.csv", everything);
    EXPECT_EQ(atoms.property_names, (Words{"element", "m", "m 2"}));
    EXPECT_EQ(values(atoms, "element"), "Na Cl");
    EXPECT_EQ(values(atoms, "m 2"), "2 4");
    // What holds nothing is no choice.
    EXPECT_EQ(read_csv("x,y,z,q\n0,0,0,\n", "a.csv", everything).property_names, Words{});
}

TEST(PropertiesOfCsv, OfVeryManyWordsAreNone) {
    std::string table = "x,y,z,word\n";
    for (int i = 0; i < 70'000; ++i) table += "0,0,0,w" + std::to_string(i) + "\n";
    const SphereData data = read_csv(table, "a.csv", everything);
    EXPECT_TRUE(data.scene.properties.empty());
    EXPECT_TRUE(data.property_names.empty());
    EXPECT_NE(data.warnings.at(0).find("'word' has more than 65,536 different words and is passed over"), std::string::npos);
}

TEST(PropertiesOfLammps, GoWithTheOrderOfTheIds) {
    const std::string dump =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: ATOMS id type x y z vx c_pe xs\n"
        "3 2 3 0 0 0.3 -3 0.5\n1 1 1 0 0 0.1 -1.5 0.5\n2 1 2 0 0 0.2 -2 0.5\n";
    const SphereData data = read_lammps(dump, "a", everything);
    EXPECT_EQ(data.property_names, (Words{"id", "type", "vx", "c_pe", "xs"}));
    EXPECT_EQ(values(data, "id"), "1 2 3");
    EXPECT_EQ(values(data, "type"), "1 1 2");
    EXPECT_TRUE(is_category(*find_property(data.scene.properties, "type")));
    EXPECT_EQ(values(data, "vx"), "0.1 0.2 0.3");
    EXPECT_EQ(values(data, "c_pe"), "-1.5 -2 -3");
}

TEST(PropertiesOfLammps, HaveTheLengthsOfVectors) {
    const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS ";
    const SphereData data = read_lammps(head + "x y z vx vy vz fx fy\n0 0 0 0.3 0.4 0 1 2\n", "a", everything);
    EXPECT_EQ(data.property_names, (Words{"vx", "vy", "vz", "fx", "fy", "velocity"}));
    EXPECT_EQ(values(data, "velocity"), "0.5");
}

TEST(PropertiesOfLammps, HaveElements) {
    const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS ";
    EXPECT_EQ(values(read_lammps(head + "type x y z\nFe 0 0 0\n", "a", everything), "element"), "Fe");
    EXPECT_EQ(values(read_lammps(head + "element x y z\n26 0 0 0\n", "a", everything), "element"), "Fe");
    EXPECT_EQ(values(read_lammps(head + "type x y z\n26 0 0 0\n", "a", everything), "element"), "none");
}

TEST(PropertiesOfPdb, AreOfTheAtomsThatAreKept) {
    const std::string pdb =
        "ATOM      1  CA AALA A  52A      1.000   0.000   0.000  0.40 30.00           C1-\n"
        "ATOM      2  CA BALA A  52A      2.000   0.000   0.000  0.60 20.50           C2+\n"
        "HETATM    3  O   HOH B   1       3.000   0.000   0.000  1.00                 O\n";
    const SphereData data = read_pdb(pdb, "a.pdb", everything);
    EXPECT_EQ(data.property_names,
              (Words{"element", "atom", "residue", "residue_number", "chain", "b_factor", "occupancy", "charge"}));
    EXPECT_EQ(values(data, "element"), "C O");
    EXPECT_EQ(values(data, "atom"), "CA O");
    EXPECT_EQ(values(data, "residue"), "ALA HOH");
    EXPECT_EQ(values(data, "residue_number"), "52 1");
    EXPECT_EQ(values(data, "chain"), "A B");
    EXPECT_EQ(values(data, "b_factor"), "20.5 .");
    EXPECT_EQ(values(data, "occupancy"), "0.6 1");
    EXPECT_EQ(values(data, "charge"), "2 .");
    EXPECT_TRUE(read_pdb(pdb, "a.pdb", {}).scene.properties.empty());
    EXPECT_EQ(read_pdb(pdb, "a.pdb", {}).property_names.size(), 8U);
}

TEST(PropertiesOfPqr, HaveChargesAndRadii) {
    const SphereData data = read_pqr("ATOM 1 N ALA 1 0 0 0 -0.3000 1.8240\nATOM 2 CA ALA 1 1 0 0 0.0337 1.9080\n", "a", everything);
    EXPECT_EQ(data.property_names, (Words{"element", "atom", "residue", "residue_number", "charge", "radius"}));
    EXPECT_EQ(values(data, "charge"), "-0.3 0.0337");
    EXPECT_EQ(values(data, "radius"), "1.824 1.908");
}

TEST(PropertiesOfGromacs, HaveVelocities) {
    const std::string gro =
        "t\n2\n    1SOL     OW    1   0.100   0.200   0.300  0.3000  0.4000  0.0000\n"
        "    2ALA     CA    2   0.400   0.500   0.600  0.0000  0.0000 -1.0000\n1 1 1\n";
    const SphereData data = read_gromacs(gro, "a.gro", everything);
    EXPECT_EQ(values(data, "element"), "O C");
    EXPECT_EQ(values(data, "residue"), "SOL ALA");
    EXPECT_EQ(values(data, "residue_number"), "1 2");
    EXPECT_EQ(values(data, "velocity"), "0.5 1");
    EXPECT_EQ(values(data, "velocity.z"), "0 -1");
    EXPECT_EQ(read_gromacs("t\n1\n    1SOL     OW    1   0.100   0.200   0.300\n1 1 1\n", "a.gro", {}).property_names,
              (Words{"element", "atom", "residue", "residue_number"}));
}

TEST(PropertiesOfCrystalsAndMolecules, HaveElements) {
    const std::string poscar = "t\n1\n1 0 0\n0 1 0\n0 0 1\nFe_pv O\n1 2\nDirect\n0 0 0\n0.5 0 0\n0 0.5 0\n";
    EXPECT_EQ(values(read_poscar(poscar, "POSCAR", everything), "element"), "Fe O O");
    const std::string sdf =
        "a\n\n\n  2  0  0  0  0  0            999 V2000\n    0.0 0.0 0.0 C   0  0\n    1.0 0.0 0.0 cl  0  0\nM  END\n";
    EXPECT_EQ(values(read_sdf(sdf, "a.sdf", everything), "element"), "C Cl");
}

TEST(PropertiesOfSdf, AreElementsAndCharges) {
    const std::string head = "ammonium\n\n\n  3  0  0  0  0  0  0  0  0  0999 V2000\n";
    const std::string atoms =
        "    0.0000    0.0000    0.0000 N   0  3  0  0\n    1.0000    0.0000    0.0000 O   0  5  0  0\n"
        "    2.0000    0.0000    0.0000 C   0  4  0  0\n";
    EXPECT_EQ(values(read_sdf(head + atoms + "M  END\n", "a.sdf", everything), "charge"), "1 -1 0");
    // What is said behind the bonds stands for all of the molecule, and not for the next one.
    const std::string listed = head + atoms + "M  CHG  2   2  -2   3   1\nM  RAD  1   1   2\nM  END\n$$$$\n";
    const std::string next = head + atoms + "M  CHG  1   1   2\nM  END\n";
    EXPECT_EQ(values(read_sdf(listed + next, "a.sdf", everything), "charge"), "0 -2 1");
    EXPECT_EQ(values(read_sdf(listed + next, "a.sdf", {.frame = 1, .all_properties = true}), "charge"), "2 0 0");
    const SphereData v3000 = read_sdf(
        "a\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 3 0 0 0 0\nM  V30 BEGIN ATOM\n"
        "M  V30 1 N 0 0 0 0 CHG=1\nM  V30 2 O 1 0 0 0 -\nM  V30 MASS=17 CHG=-1\nM  V30 3 C 2 0 0 0\nM  V30 END ATOM\n"
        "M  V30 END CTAB\nM  END\n",
        "a.sdf", everything);
    EXPECT_EQ(v3000.property_names, (Words{"element", "charge"}));
    EXPECT_EQ(values(v3000, "element"), "N O C");
    EXPECT_EQ(values(v3000, "charge"), "1 -1 0");
}

TEST(PropertiesOfPly, HaveTheirOwnSize) {
    const std::string head =
        "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nproperty float heat\nproperty list uchar int ring\nproperty short n\nproperty double "
        "big\nend_header\n";
    const SphereData text =
        read_ply("ply\nformat ascii 1.0\n" + head + "0 0 0 1 2 3 0.1 2 7 7 -3 0.1\n1 0 0 1 2 3 nan 0 4 1e300\n", "a", everything);
    EXPECT_EQ(text.property_names, (Words{"heat", "n", "big"}));
    EXPECT_EQ(values(text, "heat"), "0.1 .");
    EXPECT_EQ(values(text, "n"), "-3 4");
    EXPECT_EQ(values(text, "big"), "0.1 1e+300");
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(text.scene.properties[0].values));
    EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(text.scene.properties[1].values));

    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
        "property float heat\nend_header\n";
    for (const float value : {0.0F, 0.0F, 0.0F, 0.1F, NAN, 0.0F, 0.0F, 0.2F}) {
        std::array<char, sizeof value> four{};
        std::memcpy(four.data(), &value, sizeof value);
        bytes.append(four.data(), four.size());
    }
    // The vertex without a place goes with its value.
    EXPECT_EQ(values(read_ply(bytes, "a", everything), "heat"), "0.1");
}

#ifndef WITHOUT_GEMMI

TEST(PropertiesOfMmcif, AreThoseOfPdb) {
    const std::string head =
        "data_a\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.auth_atom_id\n_atom_site.auth_comp_id\n"
        "_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "_atom_site.occupancy\n_atom_site.B_iso_or_equiv\n_atom_site.pdbx_formal_charge\n";
    const SphereData data =
        read_mmcif(head + "1 C CA ALA A 7 0 0 0 1.0 90.5 ?\n2 O O HOH B 8 1 0 0 0.5 12 -1\n", "a.cif", everything);
    EXPECT_EQ(values(data, "b_factor"), "90.5 12");
    EXPECT_EQ(values(data, "occupancy"), "1 0.5");
    EXPECT_EQ(values(data, "charge"), ". -1");
    EXPECT_EQ(values(data, "chain"), "A B");
    EXPECT_EQ(values(data, "residue_number"), "7 8");
}

TEST(PropertiesOfCrystals, GoToEveryImage) {
    const std::string cif =
        "data_a\n_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\nloop_\n_space_group_symop_operation_xyz\nx,y,z\n-x,-y,-z\n"
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_U_iso_or_equiv\n"
        "Na1 0.2 0.2 0.2 0.012(3)\nCl1 0 0 0 0.02\n";
    const SphereData data = read_mmcif(cif, "a.cif", everything);
    EXPECT_EQ(values(data, "element"), "Na Na Cl");
    EXPECT_EQ(values(data, "u_iso"), "0.012 0.012 0.02");
    EXPECT_EQ(data.property_names, (Words{"element", "atom", "u_iso"}));
}

#endif

}  // namespace sphereview

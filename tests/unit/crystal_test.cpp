// Crystals and chemical components of CIF.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

#ifndef WITHOUT_GEMMI

namespace {

SphereData cif(const std::string& text, const DataOptions& options = {}) { return read_mmcif(text, "a.cif", options); }

const std::string cif_cell =
    "data_NaCl\n_cell_length_a 5.64\n_cell_length_b 5.64\n_cell_length_c 5.64\n_cell_angle_alpha 90\n_cell_angle_beta 90\n"
    "_cell_angle_gamma 90\n";
const std::string cif_sites =
    "loop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";
const std::string cif_salt = "Na1 Na 0 0 0\nCl1 Cl 0.5 0.5 0.5\n";

Centers cif_centers(const std::string& text) { return centers_of(cif(text).scene); }

using CellPlaces = Centers;

}  // namespace

TEST(Crystal, ReadsPartsOfTheCell) {
    const SphereData data = cif(cif_cell + "_symmetry_space_group_name_H-M \"P 1\"\n" + cif_sites + cif_salt);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(0, 0, 0));
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(2.82, 2.82, 2.82));
    EXPECT_EQ(data.scene.spheres[1].radius, find_element("Cl")->radius);
    EXPECT_EQ(data.scene.names.at(0), "Na1");
    EXPECT_EQ(data.frames, 1);
    EXPECT_TRUE(data.warnings.empty());
    EXPECT_EQ(cif(cif_cell + cif_sites + cif_salt).scene, data.scene);
    // DDLm's tags have a point.
    std::string dotted = cif_cell + cif_sites + cif_salt;
    for (const std::string tag : {"_cell_", "_atom_site_"}) {
        for (std::size_t at = 0; (at = dotted.find(tag, at)) != std::string::npos; ++at) dotted[at + tag.size() - 1] = '.';
    }
    EXPECT_EQ(cif(dotted).scene, data.scene);
}

TEST(Crystal, ValuesHaveUncertaintiesAndLabelsTellElements) {
    const std::string text =
        "data_a\n_cell_length_a 4.0(1)\n_cell_length_b 4\n_cell_length_c 4\nloop_\n_atom_site_label\n"
        "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\nCa1 0.25(3) 0 0\nO1W -0.25 0 0\nC2A ? ? ?\n";
    const SphereData data = cif(text);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0].center.x, 1.0);
    EXPECT_EQ(data.scene.spheres[0].color, find_element("Ca")->color);
    EXPECT_EQ(data.scene.spheres[1].center.x, -1.0);  // as it is written
    EXPECT_EQ(data.scene.spheres[1].color, find_element("O")->color);
    EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.cif: 1 atom has no coordinates and is left out"}));
}

TEST(Crystal, SymmetryRepeatsTheAtoms) {
    const std::string named = cif_cell + "_symmetry_space_group_name_H-M 'F m -3 m'\n" + cif_sites + cif_salt;
    const Scene salt = cif(named).scene;
    ASSERT_EQ(salt.spheres.size(), 8U);
    EXPECT_EQ(salt.spheres[0].center, glm::dvec3(0, 0, 0));
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(salt.names.at(static_cast<std::uint32_t>(i)), i < 4 ? "Na1" : "Cl1");
    EXPECT_EQ(cif(cif_cell + "_space_group_IT_number 225\n" + cif_sites + cif_salt).scene, salt);
    // Operations that are listed count more than a name, and an atom on an element of symmetry is there once.
    const std::string listed =
        cif_cell +
        "_space_group_name_H-M_alt 'F m -3 m'\nloop_\n_space_group_symop_operation_xyz\nx,y,z\n'-x, -y, -z'\n"
        "x,y,-z+1/2\n" +
        cif_sites + "Na1 Na 0.25 0 0\nCl1 Cl 0.5001 0.4999 0.25\n";
    const std::vector<glm::dvec3> centers = cif_centers(listed);
    ASSERT_EQ(centers.size(), 5U);
    EXPECT_EQ(centers[0], glm::dvec3(1.41, 0, 0));
    EXPECT_EQ(centers[1], glm::dvec3(0.75 * 5.64, 0, 0));
    EXPECT_EQ(centers[2], glm::dvec3(1.41, 0, 2.82));
    EXPECT_EQ(centers[3], glm::dvec3(0.5001 * 5.64, 0.4999 * 5.64, 1.41));
    EXPECT_NEAR(centers[4].z, 4.23, 1e-12);
    // Fractions may be decimal.
    const std::string halves = cif_cell + "_symmetry_equiv_pos_as_xyz ";
    for (const char* half : {"x+1/2,y,z", "x+0.5,y,z", "0.5+x,y,z", "'.5+x, y, z'", "X+0.50000,Y,Z", "12.5+x,y,z"}) {
        EXPECT_EQ(cif(halves + half + "\n" + cif_sites + "Na1 Na 0 0 0\n").scene.spheres.at(1).center.x, 2.82) << half;
    }
    for (const char* third : {"x+1/3,y,z", "x+0.33,y,z", "x+.3333,y,z"}) {
        EXPECT_EQ(cif_centers(halves + third + "\n" + cif_sites + "Na1 Na 0 0 0\n"),
                  cif_centers(halves + "x+1/3,y,z\n" + cif_sites + "Na1 Na 0 0 0\n"))
            << third;
    }
    const SphereData unknown = cif(cif_cell + "_symmetry_space_group_name_H-M 'Q 7'\n" + cif_sites + cif_salt);
    EXPECT_EQ(unknown.scene.spheres.size(), 2U);
    EXPECT_EQ(unknown.warnings,
              (std::vector<std::string>{"a.cif:8:32: found 'Q 7', expected a space group that is known; only the atoms that "
                                        "are listed are shown"}));
}

TEST(Crystal, TheFirstThatIsKnownOfItsSpaceGroupCounts) {
    const Scene salt = cif(cif_cell + "_symmetry_space_group_name_H-M 'F m -3 m'\n" + cif_sites + cif_salt).scene;
    const auto group = [](const std::string& tags) { return cif(cif_cell + tags + cif_sites + cif_salt); };
    for (const char* tags : {"_symmetry_space_group_name_H-M ?\n_symmetry_Int_Tables_number 225\n",
                             "_space_group_name_H-M_alt .\n_symmetry_space_group_name_H-M 'F m -3 m'\n",
                             "_space_group_IT_number ?\n_symmetry_Int_Tables_number 225\n", "_space_group_name_Hall '-F 4 2 3'\n",
                             "_symmetry_space_group_name_Hall '-F 4 2 3'\n_symmetry_space_group_name_H-M 'P 1'\n"}) {
        EXPECT_EQ(group(tags).scene.spheres.size(), salt.spheres.size()) << tags;
        EXPECT_TRUE(group(tags).warnings.empty()) << tags;
    }
    const SphereData by_number = group("_symmetry_space_group_name_H-M 'F m 3 n q'\n_symmetry_Int_Tables_number 225\n");
    EXPECT_EQ(by_number.scene, salt);
    EXPECT_EQ(by_number.warnings,
              (std::vector<std::string>{"a.cif:8:32: found 'F m 3 n q', expected a space group that is known; that of "
                                        "_symmetry_Int_Tables_number is taken"}));
    const SphereData no_hall = group("_space_group_name_Hall 'Q 7'\n");
    EXPECT_EQ(no_hall.scene.spheres.size(), 2U);
    EXPECT_EQ(no_hall.warnings.size(), 1U);
}

// Calcite. Of R there are two cells, which the angles tell apart.
TEST(Crystal, TheAnglesTellARhombohedralCell) {
    const std::string edges = "data_c\n_cell_length_a 6.375\n_cell_length_b 6.375\n_cell_length_c 6.375\n";
    const std::string angles = "_cell_angle_alpha 46.08\n_cell_angle_beta 46.08\n_cell_angle_gamma 46.08\n";
    const std::string sites = cif_sites + "Ca1 Ca 0 0 0\nC1 C .25 .25 .25\nO1 O .507 -.007 .25\n";
    for (const char* group : {"_symmetry_space_group_name_H-M 'R -3 c :R'\n", "_symmetry_space_group_name_H-M 'R -3 c'\n",
                              "_symmetry_Int_Tables_number 167\n"}) {
        EXPECT_EQ(cif(edges + angles + group + sites).scene.spheres.size(), 10U) << group;
    }
    const std::string hexagonal = "data_c\n_cell_length_a 4.99\n_cell_length_b 4.99\n_cell_length_c 17.06\n_cell_angle_gamma 120\n";
    const std::string in_hexagonal = cif_sites + "Ca1 Ca 0 0 0\nC1 C 0 0 .25\nO1 O .257 0 .25\n";
    for (const char* group : {"_symmetry_space_group_name_H-M 'R -3 c'\n", "_symmetry_Int_Tables_number 167\n"}) {
        EXPECT_EQ(cif(hexagonal + group + in_hexagonal).scene.spheres.size(), 30U) << group;
    }
}

TEST(Crystal, DummiesAreNoAtoms) {
    const SphereData data = cif(cif_cell +
                                "loop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n"
                                "_atom_site_fract_z\n_atom_site_calc_flag\nC1 C .1 .1 .1 d\nX1 C .2 .2 .2 dum\n");
    EXPECT_EQ(data.scene.spheres.at(0).radius, find_element("C")->radius);
    EXPECT_EQ(data.scene.spheres.at(1).radius, virtual_site().radius);
    EXPECT_EQ(data.warnings.size(), 1U);
}

TEST(Crystal, RowsWithoutPlacesAreLeftOutAndCounted) {
    const SphereData data = cif(cif_cell + cif_sites + "Na1 Na 0 0 0\nNa2 Na nan 0 0\nNa3 Na 0 ? .\n");
    EXPECT_EQ(data.scene.spheres.size(), 1U);
    EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.cif: 2 atoms have no coordinates and are left out"}));
}

TEST(Crystal, PlacesMayBeNoPartsOfACell) {
    const SphereData data =
        cif("data_x\nloop_\n_atom_site_label\n_atom_site_Cartn_x\n_atom_site_Cartn_y\n_atom_site_Cartn_z\nC1 1 2 3\nWat1 4 5 6\n");
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(1, 2, 3));
    EXPECT_EQ(data.scene.spheres[1].radius, find_element("O")->radius);
    EXPECT_EQ(data.scene.names.at(0), "C1");
}

TEST(Crystal, OfDisorderedGroupsTheFullestIsKept) {
    const std::string text =
        cif_cell +
        "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n"
        "_atom_site_disorder_assembly\n_atom_site_disorder_group\nO1 0 0 0 1 . .\nC1 0.1 0 0 0.3 A 1\nC2 0.2 0 0 0.7(1) A 2\n"
        "C3 0.3 0 0 0.7 A 2\nC4 0.4 0 0 0.5 B 1\n";
    const SphereData data = cif(text);
    std::string names;
    for (const auto& [number, name] : data.scene.names) names += name + " ";
    EXPECT_EQ(names, "O1 C2 C3 C4 ");
    EXPECT_EQ(data.notes, (std::vector<std::string>{"a.cif: 1 atom is left out: of disordered groups the fullest is shown"}));
}

TEST(Component, ReadsItsModel) {
    const std::string head =
        "data_LIG\n_chem_comp.id LIG\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n"
        "_chem_comp_atom.type_symbol\n";
    const std::string model = "_chem_comp_atom.model_Cartn_x\n_chem_comp_atom.model_Cartn_y\n_chem_comp_atom.model_Cartn_z\n";
    const std::string ideal =
        "_chem_comp_atom.pdbx_model_Cartn_x_ideal\n_chem_comp_atom.pdbx_model_Cartn_y_ideal\n"
        "_chem_comp_atom.pdbx_model_Cartn_z_ideal\n";
    const Scene scene = cif(head + model + "LIG C1 C 0.0 0.0 0.0\nLIG O1 O 1.2 0.0 0.0\n").scene;
    ASSERT_EQ(scene.spheres.size(), 2U);
    EXPECT_EQ(scene.spheres[1].center, glm::dvec3(1.2, 0, 0));
    EXPECT_EQ(scene.spheres[0].color, find_element("C")->color);
    EXPECT_EQ(scene.names.at(1), "LIG/O1");
    // Where the model is not known, the ideal places.
    EXPECT_EQ(cif_centers(head + model + ideal + "LIG C1 C ? ? ? 1 2 3\n"), (CellPlaces{{1, 2, 3}}));
    EXPECT_EQ(cif_centers(head + model + ideal + "LIG C1 C 4 5 6 1 2 3\n"), (CellPlaces{{4, 5, 6}}));
    EXPECT_EQ(cif_centers(head + "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\nLIG C1 C 7 8 9\n"),
              (CellPlaces{{7, 8, 9}}));
    // Each component is a frame, and so is each block of any kind.
    const std::string two = head + model + "LIG C1 C 0 0 0\nATP P1 P 1 1 1\n" + cif_cell + cif_sites + cif_salt;
    EXPECT_EQ(cif(two).frames, 3);
    EXPECT_EQ(cif(two, {.frame = 1}).scene.names.at(0), "ATP/P1");
    EXPECT_EQ(cif(two, {.frame = 2}).scene.spheres.size(), 2U);
}

TEST(CrystalErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { cif(text); };
    const std::string edge = "_cell_length_a 5\n_cell_length_b 5\n_cell_length_c 5\n";
    std::string many = cif_cell + "loop_\n_symmetry_equiv_pos_as_xyz\n";
    for (int i = 0; i < 400; ++i) many += "x,y,z\n";
    expect_messages(
        "a.cif", read,
        {
            {"data_a\n" + cif_sites + cif_salt,
             "3:1: found places in parts of a cell, expected its lengths too, as _cell_length_a"},
            {"data_a\n_cell_length_a 0\n_cell_length_b 5\n_cell_length_c 5\n" + cif_sites + cif_salt,
             "2:16: found '0', expected _cell_length_a above 0"},
            {"data_a\n_cell_length_a -5\n_cell_length_b 5\n_cell_length_c 5\n" + cif_sites + cif_salt,
             "2:16: found '-5', expected _cell_length_a above 0"},
            {"data_a\n_cell_length_a long\n" + cif_sites + cif_salt, "2:16: found 'long', expected _cell_length_a, a number"},
            {"data_a\n" + edge + "_cell_angle_alpha 180\n" + cif_sites + cif_salt,
             "2:1: found angles 180, 90 and 90, expected angles that a cell can have"},
            {cif_cell + cif_sites + "Na1 Na zero 0 0\n", "14:8: found 'zero', expected fract_x of atom 1 of the table, a number"},
            {cif_cell + cif_sites + "Na1 Na ? 0 0\n",
             "9:1: found a crystal's atoms without places, expected fract_x, fract_y and fract_z as numbers"},
            {cif_cell + "_symmetry_equiv_pos_as_xyz x,y\n" + cif_sites + cif_salt,
             "8:28: found 'x,y', expected an operation of symmetry, as -x,y+1/2,z"},
            {cif_cell + "_symmetry_equiv_pos_as_xyz x+0.3,y,z\n" + cif_sites + cif_salt,
             "8:28: found 'x+0.3,y,z', expected an operation of symmetry, as -x,y+1/2,z"},
            {cif_cell + "_symmetry_equiv_pos_as_xyz x+0.5.5,y,z\n" + cif_sites + cif_salt,
             "8:28: found 'x+0.5.5,y,z', expected an operation of symmetry, as -x,y+1/2,z"},
            {cif_cell + "_symmetry_equiv_pos_as_xyz 99999999999999999999x,y,z\n" + cif_sites + cif_salt,
             "8:28: found '99999999999999999999x,y,z', expected an operation of symmetry, as -x,y+1/2,z"},
            {cif_cell + "loop_\n_symmetry_equiv_pos_site_id\n_symmetry_equiv_pos_as_xyz\n1 x,y,z\n2 'x,-y'\n" + cif_sites +
                 cif_salt,
             "12:3: found ''x,-y'', expected an operation of symmetry, as -x,y+1/2,z"},
            {many + cif_sites + cif_salt, "394:1: found more operations of symmetry, expected at most 384"},
            {"data_a\n_cell_length_a 1e300\n_cell_length_b 5\n_cell_length_c 5\n" + cif_sites + "Na1 Na 1e300 0 0\n",
             "11:8: found atom 1 of the table beyond what a double can hold, expected its place"},
        });
}

#endif

}  // namespace sphereview

// PDB and mmCIF.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "formats/elements.hpp"
#include "formats/sphere_data.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

// Columns:                          1         2         3         4         5         6         7         8
//                          12345678901234567890123456789012345678901234567890123456789012345678901234567890
const std::string nitrogen = "ATOM      1  N   ALA A  12      17.047  14.099   3.625  1.00 13.79           N\n";
const std::string carbon_a = "ATOM      2  CA AALA A  12      16.967  12.784   4.338  0.40 10.80           C\n";
const std::string carbon_b = "ATOM      3  CA BALA A  12      16.900  12.700   4.400  0.60 10.80           C\n";
const std::string oxygen = "ATOM      4  O   SER A  52A     -1.000  -2.500   0.000  1.00 10.00           O1-\n";
const std::string iron = "HETATM    5 FE   HEM A 154      14.000   1.000   2.000  1.00 10.00          FE\n";
const std::string water = "HETATM    6  O   HOH B 201       1.000   2.000   3.000  1.00 10.00           O\n";

SphereData pdb(std::string_view content, const DataOptions& options = {}) { return read_pdb(content, "a.pdb", options); }

std::vector<std::string> names_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const auto& [index, name] : scene.names) names.push_back(name);
    return names;
}

using Names = std::vector<std::string>;

std::string pdb_fault(std::string_view content, const DataOptions& options = {}) {
    return message_of<InputError>([&] { pdb(content, options); });
}

TEST(Pdb, GivesAtomsWithTheirElementsAndNames) {
    const std::string content = "HEADER    PLANT PROTEIN                           30-APR-81   1CRN\n" + nitrogen + oxygen +
                                "TER       4      SER A  52A\n" + iron + water + "CONECT    1    2\nEND\n";
    const SphereData data = pdb(content);
    EXPECT_EQ(data.frames, 1);
    ASSERT_EQ(data.scene.spheres.size(), 4U);
    EXPECT_EQ(names_of(data.scene), (Names{"A/ALA 12/N", "A/SER 52A/O", "A/HEM 154/FE", "B/HOH 201/O"}));
    EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(17.047, 14.099, 3.625));
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(-1.0, -2.5, 0.0));
    const std::vector<const char*> symbols = {"N", "O", "Fe", "O"};
    for (std::size_t i = 0; i < symbols.size(); ++i) {
        EXPECT_EQ(data.scene.spheres[i].color, find_element(symbols[i])->color) << i;
        EXPECT_EQ(data.scene.spheres[i].radius, find_element(symbols[i])->radius) << i;
    }
}

TEST(Pdb, TakesTheElementFromTheNameWhereThereIsNone) {
    const auto color = [](const std::string& line) { return pdb(line).scene.spheres.at(0).color; };
    EXPECT_EQ(color("ATOM      2  CA  ALA A  12      16.967  12.784   4.338\n"), find_element("C")->color);
    EXPECT_EQ(color("HETATM    2 CA    CA A  12      16.967  12.784   4.338\n"), find_element("Ca")->color);
    EXPECT_EQ(color("ATOM      2 HG11 VAL A  12      16.967  12.784   4.338\n"), find_element("H")->color);
    EXPECT_EQ(color("HETATM    2  ?   UNX A  12      16.967  12.784   4.338\n"), unknown_element().color);
}

TEST(Pdb, TakesTheRadiusThatIsGiven) {
    for (const Sphere& sphere : pdb(nitrogen + oxygen, {.radius = 2.5}).scene.spheres) EXPECT_EQ(sphere.radius, 2.5);
}

TEST(Pdb, KeepsTheFullestAlternative) {
    const SphereData data = pdb(nitrogen + carbon_a + carbon_b + oxygen);
    ASSERT_EQ(data.scene.spheres.size(), 3U);
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(16.9, 12.7, 4.4));
    std::string equal = carbon_b;
    equal.replace(56, 4, "0.40");
    EXPECT_EQ(pdb(carbon_a + equal).scene.spheres.at(0).center, glm::dvec3(16.967, 12.784, 4.338));
    EXPECT_EQ(pdb(carbon_a + equal).scene.spheres.size(), 1U);
}

TEST(Pdb, HasAFrameForEachModel) {
    const std::string models = "MODEL        1\n" + nitrogen + "ENDMDL\nMODEL        2\n" + oxygen + iron + "ENDMDL\nEND\n";
    EXPECT_EQ(pdb(models).frames, 2);
    EXPECT_EQ(pdb(models).scene.spheres.size(), 1U);
    EXPECT_EQ(names_of(pdb(models, {.frame = 1}).scene), (Names{"A/SER 52A/O", "A/HEM 154/FE"}));
    EXPECT_EQ(pdb_fault(models, {.frame = 2}), "a.pdb: found 2 frames, 0 to 1, expected frame 2");
    // What programs for trajectories write.
    for (const std::string end : {"END\n", "ENDMDL\n", "END   \r\n"}) {
        const std::string content = nitrogen + end + water + end;
        EXPECT_EQ(pdb(content).frames, 2) << end;
        EXPECT_EQ(names_of(pdb(content, {.frame = 1}).scene), (Names{"B/HOH 201/O"})) << end;
    }
}

TEST(Pdb, LinesEndInAnyWay) {
    const Scene expected = pdb(nitrogen + oxygen).scene;
    for (const std::string end : {"\r\n", "\r"}) {
        std::string content;
        for (const char c : nitrogen + oxygen) {
            if (c == '\n') {
                content += end;
            } else {
                content += c;
            }
        }
        EXPECT_EQ(pdb(content).scene, expected);
    }
}

TEST(Pdb, BadPlacesAreReported) {
    const auto with = [](std::size_t column, const std::string& text) {
        std::string line = nitrogen;
        line.replace(column - 1, text.size(), text);
        return pdb_fault("TITLE\n" + line);
    };
    EXPECT_EQ(with(31, "  17.0x7"), "a.pdb:2:33: found '17.0x7', expected the atom's x in columns 31 to 38, a number");
    EXPECT_EQ(with(39, "     nan"), "a.pdb:2:44: found 'nan', expected the atom's y in columns 39 to 46, a number");
    EXPECT_EQ(with(39, "   1e999"), "a.pdb:2:42: found '1e999', expected the atom's y in columns 39 to 46, a number");
    EXPECT_EQ(with(47, "        "), "a.pdb:2:47: found '        ', expected the atom's z in columns 47 to 54, a number");
    EXPECT_EQ(with(47, "  3.62 5"), "a.pdb:2:49: found '3.62 5', expected the atom's z in columns 47 to 54, a number");
    EXPECT_EQ(pdb_fault(nitrogen.substr(0, 46)), "a.pdb:1:47: the line ends, expected the atom's z in columns 47 to 54");
    EXPECT_EQ(with(14, std::string(1, '\0')), "a.pdb:2:14: found a zero byte, expected text");
    EXPECT_EQ(pdb(nitrogen.substr(0, 54)).scene.spheres.at(0).center, pdb(nitrogen).scene.spheres.at(0).center);
    EXPECT_EQ(pdb_fault(""), "a.pdb:1:1: the text is empty, expected a record ATOM or HETATM");
    EXPECT_EQ(pdb_fault("HEADER\nMODEL 1\nENDMDL\n"), "a.pdb:4:1: the text ends, expected a record ATOM or HETATM");
}

TEST(Pdb, EveryNumberIsReadAsItIs) {
    const auto x = [](const std::string& text) {
        std::string line = nitrogen;
        line.replace(30, text.size(), text);
        return pdb(line).scene.spheres.at(0).center.x;
    };
    EXPECT_EQ(x("  +1.047"), 1.047);
    EXPECT_EQ(x("-999.999"), -999.999);
    EXPECT_EQ(x("12345678"), 12345678.0);
    EXPECT_EQ(x("-.5     "), -0.5);
    EXPECT_EQ(x("     1e3"), 1000.0);
    EXPECT_EQ(x("      5."), 5.0);
}

TEST(Pdb, ManyAtomsHaveNoNames) {
    std::string content;
    for (std::size_t i = 0; i <= most_named_atoms; ++i) content += nitrogen;
    const SphereData data = pdb(content);
    EXPECT_EQ(data.scene.spheres.size(), most_named_atoms + 1);
    EXPECT_TRUE(data.scene.names.empty());
}

#ifdef WITHOUT_GEMMI
TEST(Mmcif, CannotBeReadByThisBuildAsItSays) {
    EXPECT_EQ(message_of<InputError>([] { read_mmcif("", "a.cif", {}); }),
              "a.cif: this program was built without gemmi, and cannot read mmCIF");
}
#else

SphereData mmcif(std::string_view content, const DataOptions& options = {}) { return read_mmcif(content, "a.cif", options); }

std::string mmcif_fault(std::string_view content, const DataOptions& options = {}) {
    return message_of<InputError>([&] { mmcif(content, options); });
}

const std::string cif_columns =
    "data_1CRN\n#\n_struct.title 'It''s # a title'\nloop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
    "_atom_site.label_atom_id\n_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
    "_atom_site.label_seq_id\n_atom_site.pdbx_PDB_ins_code\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
    "_atom_site.occupancy\n_atom_site.auth_seq_id\n_atom_site.auth_asym_id\n_atom_site.pdbx_PDB_model_num\n";
const std::string cif_atoms =
    "ATOM 1 N N . ALA A 1 ? 17.047 14.099 3.625 1.0 12 X 1\n"
    "ATOM 2 C CA A ALA A 1 ? 16.967 12.784 4.338 0.4 12 X 1\n"
    "ATOM 3 C CA B ALA A 1 ? 16.9 12.7 4.4(2) 0.6 12 X 1\n"
    "ATOM 4 C \"C5'\" . G A 2 B 1 -2.5e0 3 1.0 13 X 1\n"
    "HETATM 5 FE FE . HEM B . ? 14 1 2 1.0 154 X 1\n"
    "ATOM 6 H H . ALA A 1 ? 1 1 1 1.0 12 X 2\n#\n";
const std::string cif_places = "data_x\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

TEST(Mmcif, GivesAtomsWithTheirElementsAndNames) {
    const SphereData data = mmcif(cif_columns + cif_atoms);
    EXPECT_EQ(data.frames, 2);
    EXPECT_EQ(names_of(data.scene), (Names{"X/ALA 12/N", "X/ALA 12/CA", "X/G 13B/C5'", "X/HEM 154/FE"}));
    ASSERT_EQ(data.scene.spheres.size(), 4U);
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(16.9, 12.7, 4.4));
    EXPECT_EQ(data.scene.spheres[2].center, glm::dvec3(1.0, -2.5, 3.0));
    EXPECT_EQ(data.scene.spheres[2].color, find_element("C")->color);
    EXPECT_EQ(data.scene.spheres[3].radius, find_element("Fe")->radius);
    EXPECT_EQ(mmcif(cif_columns + cif_atoms, {.radius = 2.0}).scene.spheres[3].radius, 2.0);
}

TEST(Mmcif, HasAFrameForEachModel) {
    const std::string content = cif_columns + cif_atoms;
    EXPECT_EQ(names_of(mmcif(content, {.frame = 1}).scene), (Names{"X/ALA 12/H"}));
    EXPECT_EQ(mmcif_fault(content, {.frame = 2}), "a.cif: found 2 frames, 0 to 1, expected frame 2");
}

TEST(Mmcif, TheModelsOfASecondBlockAreMoreFrames) {
    const std::string places = cif_places.substr(cif_places.find('\n'));
    const std::string content = cif_columns + cif_atoms + "data_y\n_cell.length_a 1\ndata_z" + places + "1 2 3\n4 5 6\n";
    EXPECT_EQ(mmcif(content).frames, 3);
    EXPECT_EQ(names_of(mmcif(content).scene), (Names{"X/ALA 12/N", "X/ALA 12/CA", "X/G 13B/C5'", "X/HEM 154/FE"}));
    EXPECT_EQ(names_of(mmcif(content, {.frame = 1}).scene), (Names{"X/ALA 12/H"}));
    EXPECT_EQ(mmcif(content, {.frame = 2}).scene.spheres.at(1).center, glm::dvec3(4, 5, 6));
    EXPECT_EQ(mmcif_fault(content, {.frame = 3}), "a.cif: found 3 frames, 0 to 2, expected frame 3");
    EXPECT_TRUE(mmcif(content).warnings.empty());
    // What is wrong with another block is only said.
    const SphereData data = mmcif(cif_places + "1 2 3\ndata_y\n_atom_site.Cartn_x 1\n");
    EXPECT_EQ(data.frames, 1);
    EXPECT_EQ(data.warnings, (Names{"a.cif:8:1: found a table of atoms without one of their places, expected Cartn_x, Cartn_y and "
                                    "Cartn_z; passed over"}));
}

TEST(Mmcif, NeedsOnlyPlaces) {
    EXPECT_EQ(mmcif(cif_places + "1 2 3\n4 5 6").scene.spheres.size(), 2U);
    const Scene pairs = mmcif("data_x\n_ATOM_SITE.CARTN_X 1\n_atom_site.Cartn_y '2'\n_atom_site.Cartn_z 3\n").scene;
    EXPECT_EQ(pairs, mmcif(cif_places + "1 2 3\n").scene);
    EXPECT_EQ(mmcif("\xEF\xBB\xBF" + cif_places + "1 2 3\n").scene, pairs);
}

TEST(Mmcif, RowsWithoutPlacesAreLeftOutAndCounted) {
    const SphereData data = read_mmcif(cif_places + "1 2 3\n? ? ?\n. 5 6\nNaN nan nan\n7 8 9\n", "a.cif", {});
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(7, 8, 9));
    EXPECT_EQ(data.warnings, (std::vector<std::string>{"a.cif: 3 atoms have no coordinates and are left out"}));
}

TEST(Mmcif, FaultsAreReported) {
    EXPECT_EQ(mmcif_fault(cif_places + "1 2 3\n1 two 3\n"), "a.cif:7:3: found 'two', expected y of atom 2 of the table, a number");
    EXPECT_EQ(mmcif_fault(cif_places + "1 2 ?\nnan 2 3\n"),
              "a.cif:3:1: found atoms without places, expected Cartn_x, Cartn_y and Cartn_z as numbers");
    // Behind quotes, comments and text fields, whose words are none of the table's.
    EXPECT_EQ(mmcif_fault(cif_places + "'1' 2 # 3 4\n3 1\n;\n2 3\n;\n4\n"),
              "a.cif:8:1: found ';\\x0a2 3\\x0a;', expected y of atom 2 of the table, a number");
    EXPECT_EQ(mmcif_fault("data_x _a '' _b 'it''s' loop_ _atom_site.Cartn_z _atom_site.Cartn_x _atom_site.cartn_Y 1 2 'a'b'"),
              "a.cif:1:92: found ''a'b'', expected y of atom 1 of the table, a number");
    EXPECT_EQ(mmcif_fault("data_x\n_atom_site.Cartn_x 1\n_atom_site.Cartn_y two\n_atom_site.Cartn_z 3\n"),
              "a.cif:3:20: found 'two', expected y of atom 1 of the table, a number");
    EXPECT_TRUE(mmcif_fault(cif_places + "1 2 3 4\n").starts_with("a.cif:2:"));  // gemmi's words
    EXPECT_EQ(mmcif_fault(cif_places + "1 2 'three\n"), "a.cif:6:11: unterminated 'string'");
    EXPECT_EQ(mmcif_fault(cif_places + "1 2 3\n$ 1 2\n"), "a.cif:7:1: parse error");
    EXPECT_EQ(mmcif_fault("data_x\n_A 1\n  _a 2\n"), "a.cif:3:3: found '_a' again, expected each tag of a block once");
    EXPECT_EQ(mmcif_fault("data_w _a 1\ndata_x\nloop_ _a\n _a\n1 2\n"),
              "a.cif:4:2: found '_a' again, expected each tag of a block once");
    EXPECT_EQ(mmcif_fault("data_x\n_a 1\n_b 2 data_X _c 3\n"),
              "a.cif:3:6: found 'data_X' again, expected each name of a block once");
    EXPECT_EQ(mmcif_fault("data_x\nsave_a _b 1\nsave_\n save_a _b 1\nsave_\n"),
              "a.cif:4:2: found 'save_a' again, expected each name of a save frame once");
    EXPECT_EQ(mmcif_fault("data_x _a 1\n_b\n_c 2\n"), "a.cif:2:1: found '_b' without a value, expected one behind it");
    EXPECT_EQ(mmcif_fault("hello"), "a.cif:1:1: expected block header (data_)");
    EXPECT_EQ(mmcif_fault("data_x loop_ _atom_site.id 1"),
              "a.cif:1:14: found a table of atoms without one of their places, expected Cartn_x, Cartn_y and Cartn_z");
    EXPECT_EQ(mmcif_fault("data_x\nloop_\n_atom_site.Cartn_x\n_atom_type.symbol\n1 C\n"),
              "a.cif:4:1: found '_atom_type.symbol', expected a column of _atom_site");
    const std::string table =
        "expected the table _atom_site with Cartn_x, Cartn_y and Cartn_z, or a crystal's with fract_x, fract_y and fract_z";
    EXPECT_EQ(mmcif_fault("data_x\nloop_\n_atom_site_fract_x\n0.5\n"), "a.cif:5:1: the text ends, " + table);
    EXPECT_EQ(mmcif_fault(""), "a.cif:1:1: the text is empty, " + table);
    EXPECT_EQ(mmcif_fault("data_x\n_a.b 1\n"), "a.cif:3:1: the text ends, " + table);
    EXPECT_EQ(mmcif_fault(cif_places), "a.cif:6:1: the text ends, " + table);
}

// gemmi takes time with their product.
TEST(Mmcif, BlocksAndNamesAreBounded) {
    const auto many = [](int count, const std::string& line) {
        std::string text;
        for (int i = 0; i < count; ++i) text += line;
        return text;
    };
    EXPECT_EQ(mmcif_fault(many(100'001, "data_\n")),
              "a.cif:100001:1: found 100,001 blocks, expected at most 99,999 where up to 100,001 names are together");
    EXPECT_EQ(mmcif_fault("data_\n" + many(1'000'000, "_a\n") + many(10'001, "DATA_\n")),
              "a.cif:1010001:1: found 10,001 blocks, expected at most 10,000 where up to 1,000,000 names are together");
}

#endif

}  // namespace

}  // namespace sphereview

// VASP's POSCAR, CONTCAR and XDATCAR.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/cell.hpp"
#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

SphereData poscar(const std::string& text, const DataOptions& options = {}) { return read_poscar(text, "POSCAR", options); }

const std::string poscar_edges = "1 0 0\n0 1 0\n0 0 1\n";
const std::string poscar_salt = "NaCl\n5.64\n" + poscar_edges + "Na Cl\n1 1\nDirect\n0 0 0\n0.5 0.5 0.5\n";

Centers poscar_centers(const std::string& text, const DataOptions& options = {}) { return centers_of(poscar(text, options).scene); }

using Places = Centers;

}  // namespace

TEST(Poscar, ReadsPartsOfTheCell) {
    const SphereData data = poscar(poscar_salt);
    ASSERT_EQ(data.scene.spheres.size(), 2U);
    EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(0, 0, 0));
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(2.82, 2.82, 2.82));
    EXPECT_EQ(data.scene.spheres[0].color, find_element("Na")->color);
    EXPECT_EQ(data.scene.spheres[1].radius, find_element("Cl")->radius);
    EXPECT_EQ(data.scene.names.at(1), "Cl");
    EXPECT_EQ(data.frames, 1);
    EXPECT_TRUE(data.warnings.empty());
    for (const char* name : {"POSCAR", "dir/CONTCAR", "a.vasp", "x.poscar", "a.txt"}) {
        EXPECT_EQ(detect_format(poscar_salt, name).name, "POSCAR") << name;
    }
}

TEST(Poscar, ReadsWhatProgramsWrite) {
    // VASP 4 has no line of symbols, and names them in the title; selective dynamics; velocities behind.
    const SphereData four =
        poscar("Na Cl\n1.0\n4 0 0\n0 4 0\n1 0 4\n1 1\nSelective dynamics\nDirect\n0 0 0 T T F\n0.5 0 0.5 F F F\n\n0 0 0\n1 1 1\n");
    EXPECT_EQ(four.scene.spheres.at(1).center, glm::dvec3(2.5, 0, 2));
    EXPECT_EQ(four.scene.names.at(1), "Cl");
    EXPECT_TRUE(four.warnings.empty());
    const SphereData unknown = poscar("my cell\n1.0\n4 0 0\n0 4 0\n1 0 4\n1 1\nDirect\n0 0 0\n0.5 0 0.5\n");
    EXPECT_EQ(unknown.scene.spheres.at(0).color, unknown_element().color);
    EXPECT_TRUE(unknown.scene.names.empty());
    // Cartesian places are scaled; by three scales, too. Potentials have names. Comments behind the numbers.
    const std::string edges = "4 0 0\n0 4 0\n0 0 4\n";
    EXPECT_EQ(poscar_centers("\n2.0\n" + edges + "Fe_pv/1f2e\n1 ! iron\nCartesian\n1 2 3 Fe\n"), (Places{{2, 4, 6}}));
    EXPECT_EQ(poscar_centers("\n2 3 4\n" + edges + "Fe\n1\nkartesisch\n1 2 3\n"), (Places{{2, 6, 12}}));
    EXPECT_EQ(poscar_centers("\n2 3 4\n" + edges + "Fe\n1\nDirect\n1 1 1\n"), (Places{{8, 12, 16}}));
    EXPECT_EQ(poscar("\n1.0\n" + edges + "Fe_pv/1f2e\n1\nD\n0 0 0\n").scene.names.at(0), "Fe");
    std::string crlf;
    for (const char c : poscar_salt) crlf += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(poscar(crlf).scene, poscar(poscar_salt).scene);
}

TEST(Poscar, AScaleBelowZeroIsAVolume) {
    EXPECT_EQ(poscar_centers("\n-8\n" + poscar_edges + "H\n1\nDirect\n0.5 1 0\n"), (Places{{1, 2, 0}}));
    EXPECT_EQ(poscar_centers("\n-8\n" + poscar_edges + "H\n1\nCartesian\n0.5 1 0\n"), (Places{{1, 2, 0}}));
    EXPECT_EQ(poscar_centers("\n-64\n0 2 0\n2 0 0\n0 0 2\nH\n1\nDirect\n0.5 1 0\n"), (Places{{4, 2, 0}}));
}

TEST(Poscar, XdatcarHasFrames) {
    const std::string head = "NaCl\n5.64\n" + poscar_edges + "Na Cl\n1 1\n";
    const std::string fixed = head + "Direct configuration=     1\n0 0 0\n0.5 0 0\nDirect configuration=     2\n0 0 0\n0.25 0 0\n";
    EXPECT_EQ(poscar(fixed).frames, 2);
    EXPECT_EQ(poscar_centers(fixed, {.frame = 1}), (Places{{0, 0, 0}, {1.41, 0, 0}}));
    // The cell changes with each frame.
    const std::string moving = head + "Direct configuration=     1\n0 0 0\n0.5 0 0\nNaCl\n2.0\n" + poscar_edges +
                               "Na Cl\n1 1\nDirect configuration=     2\n0 0 0\n0.5 0 0\n";
    EXPECT_EQ(poscar_centers(moving, {.frame = 1}), (Places{{0, 0, 0}, {1, 0, 0}}));
    const SphereData cut = poscar(fixed.substr(0, fixed.size() - 9));
    EXPECT_EQ(cut.frames, 1);
    ASSERT_EQ(cut.warnings.size(), 1U);
    EXPECT_EQ(cut.warnings[0], "POSCAR:13:1: the text ends, expected atom 2 of 2 of frame 1; what follows frame 0 is passed over");
}

TEST(PoscarErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { poscar(text); };
    const std::string head = "t\n1\n" + poscar_edges;
    expect_messages(
        "POSCAR", read,
        {
            {"", "1:1: the text is empty, expected a title of frame 0"},
            {"t\n", "2:1: the text ends, expected the scale of frame 0"},
            {"t\nbig\n", "2:1: found 'big', expected the scale of frame 0, a number"},
            {"t\n0\n" + poscar_edges, "2:1: found '0', expected a scale above 0, or a volume below 0 of frame 0"},
            {"t\n1 -1 1\n" + poscar_edges, "2:1: found '1 -1 1', expected three scales above 0 of frame 0"},
            {"t\n-8\n1 0 0\n2 0 0\n0 0 1\n", "2:1: found '-8', expected a scale above 0: the edges of frame 0 span no volume"},
            {"t\n1\n1 0\n", "3:4: the line ends, expected an edge of the cell of frame 0"},
            {"t\n1\n1 0 inf\n", "3:5: found 'inf', expected an edge of the cell of frame 0, a finite number"},
            {head + "Na\n1.5\n", "7:1: found '1.5', expected the numbers of atoms of frame 0, a whole number"},
            {head + "Na\n-1\n", "7:1: found '-1', expected the numbers of atoms of frame 0 from 0 to 2000000000"},
            {head + "Na Cl\n2000000000 1\n", "7:12: found '1', expected the numbers of atoms of frame 0 from 0 to 0"},
            {head + "Na\n1\n0 0 0\n", "8:1: found '0 0 0', expected Direct or Cartesian of frame 0"},
            {head + "Na\n1\n\n", "8:1: found '', expected Direct or Cartesian of frame 0"},
            {head + "Na\n1\nDirect\n0 0\n", "9:4: the line ends, expected the z of atom 1 of 1"},
            {head + "Na\n1\nDirect\n0 nan 0\n", "9:3: found 'nan', expected the y of atom 1 of 1, a finite number"},
            {head + "Na\n2\nDirect\n0 0 0\n", "10:1: the text ends, expected atom 2 of 2 of frame 0"},
            {"t\n1e300\n" + poscar_edges + "Na\n1\nDirect\n0 1e300 0\n",
             "9:1: found a place beyond what a double can hold (at most 1.8e308), expected the place of atom 1 of 1"},
        });
}

TEST(Cell, HasEdgesOfLengthsAndAngles) {
    const Cell cube = *cell_of({2, 3, 4}, 90, 90, 90);
    EXPECT_EQ(cube.place({1, 1, 1}), glm::dvec3(2, 3, 4));
    EXPECT_EQ(cube.volume(), 24.0);
    const Cell hexagonal = *cell_of({2, 2, 5}, 90, 90, 120);
    EXPECT_NEAR(hexagonal.b.x, -1.0, 1e-15);
    EXPECT_NEAR(hexagonal.volume(), 2 * 2 * 5 * std::sqrt(3.0) / 2, 1e-13);
    const Cell any = *cell_of({3, 4, 5}, 70, 80, 100);
    const auto cosine = [](const glm::dvec3& a, const glm::dvec3& b) {
        return (a.x * b.x + a.y * b.y + a.z * b.z) /
               std::sqrt((a.x * a.x + a.y * a.y + a.z * a.z) * (b.x * b.x + b.y * b.y + b.z * b.z));
    };
    constexpr double degree = 0.017453292519943295;
    EXPECT_NEAR(cosine(any.b, any.c), std::cos(70 * degree), 1e-14);
    EXPECT_NEAR(cosine(any.a, any.c), std::cos(80 * degree), 1e-14);
    EXPECT_NEAR(cosine(any.a, any.b), std::cos(100 * degree), 1e-14);
    for (const double angle : {0.0, 180.0, -90.0, 360.0, std::nan("")}) EXPECT_FALSE(cell_of({1, 1, 1}, angle, 90, 90));
    EXPECT_FALSE(cell_of({1, 1, 1}, 120, 120, 120.1));
    EXPECT_FALSE(cell_of({1, 1, 1}, 120, 120, 120));
}

TEST(Cell, CubeRootsAreNear) {
    for (const double root : {1.0, 2.0, 3.0, 0.5, 1e100, 1e-100, 5.64, 1.9999999}) {
        EXPECT_NEAR(cube_root(root * root * root) / root, 1.0, 0x1p-50) << root;
    }
    EXPECT_EQ(cube_root(27.0), 3.0);
    EXPECT_NEAR(cube_root(5e-324) / std::cbrt(5e-324), 1.0, 0x1p-50);
}

}  // namespace sphereview

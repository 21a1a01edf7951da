// GROMACS's .gro.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

SphereData gro(const std::string& text, const DataOptions& options = {}) { return read_gromacs(text, "a.gro", options); }

const std::string gro_water =
    "water\n3\n    1SOL     OW    1   0.000   0.000   0.000\n    1SOL    HW1    2   0.100   0.000   0.000\n"
    "    1SOL    HW2    3  -0.033   0.094   0.000\n   1.0 1.0 1.0\n";

}  // namespace

TEST(Gromacs, ReadsNanometresAsAngstroms) {
    const SphereData data = gro(gro_water);
    ASSERT_EQ(data.scene.spheres.size(), 3U);
    EXPECT_EQ(data.scene.spheres[0].color, find_element("O")->color);
    EXPECT_EQ(data.scene.spheres[1].radius, find_element("H")->radius);
    EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(1, 0, 0));
    EXPECT_EQ(data.scene.spheres[2].center.y, 10.0 * 0.094);
    EXPECT_EQ(data.scene.names.at(1), "SOL 1/HW1");
    EXPECT_TRUE(data.warnings.empty());
    for (const char* name : {"a", "conf.txt", "stdin"}) EXPECT_EQ(detect_format(gro_water, name).name, "GROMACS");
    EXPECT_EQ(format_of_name("conf.gro").name, "GROMACS");
}

TEST(Gromacs, ColumnsAreAsWideAsTheDecimalsSay) {
    const std::string wide = "t= 1\n1\n  100LYS     CA99999   1.2345678   2.3456789   3.4567890  0.12345678  0.1  0.1\n 1 1 1\n";
    const SphereData data = gro(wide);
    EXPECT_EQ(data.scene.spheres.at(0).center, glm::dvec3(10.0 * 1.2345678, 10.0 * 2.3456789, 10.0 * 3.456789));
    EXPECT_EQ(data.scene.spheres.at(0).color, find_element("C")->color);
    EXPECT_EQ(data.scene.names.at(0), "LYS 100/CA");
    // Numbers may touch each other, and velocities may follow.
    const Scene touching = gro("\n1\n    1NA      NA    1-100.000-200.000-300.000 -0.1234 -0.1234 -0.1234\n 1 1 1\n").scene;
    EXPECT_EQ(touching.spheres.at(0).center, glm::dvec3(-1000, -2000, -3000));
    EXPECT_EQ(touching.spheres.at(0).color, find_element("Na")->color);
}

TEST(Gromacs, HasFrames) {
    std::string second = gro_water;
    second.replace(second.find("0.100"), 5, "0.200");
    const SphereData data = gro(gro_water + second + "\n", {.frame = 1});
    EXPECT_EQ(data.frames, 2);
    EXPECT_EQ(data.scene.spheres.at(1).center.x, 2.0);
    std::string crlf;
    for (const char c : gro_water + second) crlf += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(gro(crlf, {.frame = 1}).scene, data.scene);
    const SphereData cut = gro(gro_water + "next\n3\n    1SOL     OW    1   0.000   0.000   0.000\n");
    ASSERT_EQ(cut.warnings.size(), 1U);
    EXPECT_EQ(cut.warnings[0], "a.gro:10:1: the text ends, expected atom 2 of 3 of frame 1; what follows frame 0 is passed over");
    EXPECT_EQ(gro("no box\n0\n").scene, Scene{});
}

TEST(Gromacs, ALastLineMayBeCutShort) {
    const std::string next = "next\n2\n    1SOL     OW    1   0.000   0.000   0.000\n    1SOL    HW1    2   0.1";
    const SphereData cut = gro(gro_water + next);
    EXPECT_EQ(cut.frames, 1);
    EXPECT_EQ(cut.warnings,
              (std::vector<std::string>{"a.gro:10:27: the text ends, expected the whole line of the last atom of frame "
                                        "1; what follows frame 0 is passed over"}));
    EXPECT_NE(message_of<InputError>([&] { gro(gro_water + next, {.frame = 1}); }), "");
    // Half a number is a number, too: a line of the wanted frame is shown, and what is known of it said.
    const SphereData half = gro(gro_water + next + "00   0.000   0.1", {.frame = 1});
    EXPECT_EQ(half.scene.spheres.size(), 2U);
    EXPECT_EQ(half.warnings,
              (std::vector<std::string>{"a.gro:10:43: the text ends, expected the whole line of the last atom of frame 1"}));
    // A whole line needs neither an end nor a box.
    EXPECT_TRUE(gro(gro_water + next + "00   0.000   0.100", {.frame = 1}).warnings.empty());
    EXPECT_TRUE(gro(gro_water.substr(0, gro_water.size() - 1)).warnings.empty());
}

TEST(Gromacs, SitesThatAreNoAtomsAreSmall) {
    const std::string text =
        "tip4p\n2\n    1SOL     OW    1   0.000   0.000   0.000\n    1SOL     MW    2   0.100   0.000   0.000\n 1 1 1\n";
    EXPECT_EQ(gro(text).scene.spheres.at(1).radius, virtual_site().radius);
    EXPECT_EQ(gro(text).warnings.size(), 1U);
    EXPECT_EQ(gro(text, {.virtual_sites = false}).scene.spheres.size(), 1U);
}

TEST(GromacsErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { gro(text); };
    const std::string head = "t\n1\n    1SOL     OW    1";
    expect_messages(
        "a.gro", read,
        {
            {"", "1:1: the text is empty, expected a title and the number of atoms of frame 0"},
            {"title", "1:6: the text ends, expected the number of atoms of frame 0"},
            {"title\nmany\n", "2:1: found 'many', expected the number of atoms of frame 0, a whole number"},
            {"title\n2147483648\n", "2:1: found '2147483648', expected the number of atoms of frame 0 from 0 to 2000000000"},
            {"title\n2\n", "3:1: the text ends, expected atom 1 of 2 of frame 0"},
            {head + "\n", "3:1: found no two decimal points behind column 20, expected x, y and z in columns of equal width"},
            {"t\n1\n1 2 3\n", "3:1: found no two decimal points behind column 20, expected x, y and z in columns of equal width"},
            {head + "   0.000   0.000\n", "3:37: the line ends, expected the z of atom 1 of 1 in columns 37 to 44, a number"},
            {head + "   0.000   0.000   z.000\n",
             "3:40: found 'z.000', expected the z of atom 1 of 1 in columns 37 to 44, a number"},
            {head + "   0.000     nan   0.000\n",
             "3:24: found '0.000     nan', expected the x of atom 1 of 1 in columns 21 to 36, a number"},
        });
}

}  // namespace sphereview

// SDF and MOL.
#include <gtest/gtest.h>

#include <string>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "scene/property.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

SphereData sdf(const std::string& text, const DataOptions& options = {}) { return read_sdf(text, "a.sdf", options); }

const std::string mol_2000 =
    "CO\n own\n\n  2  1  0  0  0  0  0  0  0  0999 V2000\n    0.0000    0.0000    0.0000 C   0  0\n"
    "    1.1300    0.0000    0.0000 O   0  0\n  1  2  3  0\nM  END\n";
const std::string mol_3000 =
    "CO\n own\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 2 1 0 0 0\nM  V30 BEGIN ATOM\n"
    "M  V30 1 C 0 0 0 0 CHG=1 -\nM  V30 RAD=2\nM  V30 2 O 1.13 0 0 0\nM  V30 END ATOM\nM  V30 BEGIN BOND\nM  V30 1 3 1 2\n"
    "M  V30 END BOND\nM  V30 END CTAB\nM  END\n";

}  // namespace

TEST(Sdf, ReadsBothVersions) {
    for (const std::string& text : {mol_2000, mol_3000, mol_2000 + "$$$$\n", mol_3000 + "> <a>\nb\n\n$$$$\n\n"}) {
        const SphereData data = sdf(text);
        ASSERT_EQ(data.scene.spheres.size(), 2U) << text;
        EXPECT_EQ(data.scene.spheres[0].center, glm::dvec3(0, 0, 0));
        EXPECT_EQ(data.scene.spheres[1].center, glm::dvec3(1.13, 0, 0));
        EXPECT_EQ(data.scene.spheres[0].color, find_element("C")->color);
        EXPECT_EQ(data.scene.spheres[1].radius, find_element("O")->radius);
        EXPECT_EQ(data.scene.names.at(1), "O");
        EXPECT_EQ(data.frames, 1);
        EXPECT_TRUE(data.warnings.empty());
        for (const char* name : {"a", "a.txt", "stdin"}) EXPECT_EQ(detect_format(text, name).name, "SDF");
    }
    for (const char* name : {"a.sdf", "a.mol", "a.SD"}) EXPECT_EQ(format_of_name(name).name, "SDF");
}

TEST(Sdf, MoleculesAreFrames) {
    std::string crlf;
    for (const char c : mol_2000 + "> <x>\n1\n\n$$$$\n" + mol_3000 + "$$$$\n") crlf += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(sdf(crlf).frames, 2);
    EXPECT_EQ(sdf(crlf, {.frame = 1}).scene, sdf(mol_2000).scene);
    const SphereData cut = sdf(mol_2000 + "$$$$\n" + mol_2000.substr(0, 80));
    ASSERT_EQ(cut.warnings.size(), 1U);
    EXPECT_TRUE(cut.warnings[0].ends_with("of frame 1; what follows frame 0 is passed over")) << cut.warnings[0];
    EXPECT_EQ(message_of<InputError>([] { sdf(mol_2000, {.frame = 1}); }), "a.sdf: found 1 frame, number 0, expected frame 1");
}

TEST(Sdf, ReadsWhatProgramsWrite) {
    // Numbers of three digits touch each other; a line of counts that is not in columns; no atoms.
    std::string many = "\n\n\n100100  0  0  0  0  0  0  0  0999 V2000\n";
    for (int i = 0; i < 100; ++i) many += "    0.0000    0.0000    0.0000 H   0  0\n";
    EXPECT_EQ(sdf(many).scene.spheres.size(), 100U);
    EXPECT_EQ(sdf("\n\n\n1 0 0\n0 0 0 D\n").scene.spheres.at(0).radius, find_element("H")->radius);
    EXPECT_EQ(sdf("\n\n\n  0  0  0 V2000\nM  END\n").scene, Scene{});
    EXPECT_EQ(sdf("\n\n\n  0  0  0 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 0 0 0 0 0\nM  V30 END CTAB\nM  END\n").scene, Scene{});
    EXPECT_EQ(sdf("\n\n\n  1  0 V2000\n 1.0D0 0 0 R#\n").scene.spheres.at(0).color, unknown_element().color);
    // In the columns of an atom four whole numbers are no bond.
    const SphereData whole = sdf("\n\n\n  1  0 V2000\n        10        -2         3 6   0  0\nM  END\n");
    EXPECT_EQ(whole.scene.spheres.at(0).center, glm::dvec3(10, -2, 3));
    EXPECT_EQ(sdf("\n\n\n  1  0 V2000\n         1         2         3 6   0  0\n").scene.names.at(0), "C");
}

TEST(Sdf, NumbersMayFillTheirColumns) {
    const SphereData data =
        sdf("\n\n\n  2  0 V2000\n-1234.5678-1234.5678-1234.5678 Cl  0  5\n    0.1000-1234.5678    3.0000 O   0  0\nM  END\n",
            {.all_properties = true});
    EXPECT_EQ(data.scene.spheres.at(0).center, glm::dvec3(-1234.5678, -1234.5678, -1234.5678));
    EXPECT_EQ(data.scene.spheres.at(1).center, glm::dvec3(0.1, -1234.5678, 3));
    EXPECT_EQ(data.scene.spheres.at(1).color, find_element("O")->color);
    EXPECT_EQ(data.scene.names.at(0), "Cl");
    const Property* charge = find_property(data.scene.properties, "charge");
    ASSERT_NE(charge, nullptr);
    EXPECT_EQ(number_at(*charge, 0), -1.0);
}

// A line of V3000 may end anywhere, also within a number.
TEST(Sdf, AtomsMayGoOnInTheNextLine) {
    const std::string head =
        "\n\n\n  0  0 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 2 0 0 0 0\nM  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0\n";
    const std::string tail = "M  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
    for (const char* atom : {"M  V30 2 O 1.2 0 -\nM  V30 0 0 CHG=-1\n", "M  V30 2 O 1.-\nM  V30 2 0 0 0\n",
                             "M  V30 2 -\nM  V30 O 1.2 -\nM  V30 0 0 0\n"}) {
        const Scene scene = sdf(head + atom + tail).scene;
        ASSERT_EQ(scene.spheres.size(), 2U) << atom;
        EXPECT_EQ(scene.spheres[1].center, glm::dvec3(1.2, 0, 0)) << atom;
        EXPECT_EQ(scene.names.at(1), "O") << atom;
    }
    EXPECT_EQ(message_of<InputError>([&] { sdf(head + "M  V30 2 O 1.2 zero -\nM  V30 0 0\n" + tail); }),
              "a.sdf:9:16: found 'zero', expected the y of atom 2 of 2, a number");
}

TEST(SdfErrors, SayWhatIsWrong) {
    const auto read = [](const std::string& text) { sdf(text); };
    const std::string v3000 = "\n\n\n  0  0 V3000\n";
    expect_messages(
        "a.sdf", read,
        {
            {"", "1:1: the text is empty, expected three lines of title of frame 0"},
            {"a\nb\nc\n", "4:1: the text ends, expected the line of counts of frame 0"},
            {"a\nb\nc\nmany V2000\n", "4:1: found 'man', expected the number of atoms of frame 0 in columns 1 to 3"},
            {"a\nb\nc\n -1  0 V2000\n", "4:1: found ' -1', expected the number of atoms of frame 0 in columns 1 to 3"},
            {"a\nb\nc\n\n", "4:1: found '', expected the number of atoms of frame 0 in columns 1 to 3"},
            {"\n\n\n  2  0 V2000\n0 0 0 C\n", "6:1: the text ends, expected atom 2 of 2 of frame 0"},
            {"\n\n\n  1  0 V2000\n0 nan 0 C\n", "5:3: found 'nan', expected the y of atom 1 of 1, a finite number"},
            {"\n\n\n  1  0 V2000\n0 0 0\n", "5:6: the line ends, expected the symbol of atom 1 of 1"},
            // Wrong counts: a bond read as an atom, and an atom that would be lost.
            {"\n\n\n  2  1 V2000\n    0.0    0.0    0.0 C   0  0\n  1  2  1  0\nM  END\n",
             "6:1: found a line of a bond, expected atom 2 of 2"},
            {"\n\n\n  1  0 V2000\n    0.0    0.0    0.0 C   0  0\n    1.0    0.0    0.0 O   0  0\n  1  2  1  0\nM  END\n",
             "6:1: found a line of an atom behind 1 of 1, expected a bond or M  END of frame 0"},
            {"\n\n\n  1  0 V2000\n    0.0    0.0    0.0 C   0  0\n         1         2         3 6   0  0\nM  END\n",
             "6:1: found a line of an atom behind 1 of 1, expected a bond or M  END of frame 0"},
            {v3000 + "M  END\n", "5:1: found 'M  END', expected M  V30 BEGIN ATOM of frame 0"},
            {v3000 + "M  V30 BEGIN ATOM\n", "5:1: found 'M  V30 BEGIN ATOM', expected M  V30 COUNTS of frame 0 above it"},
            {v3000 + "M  V30 COUNTS 1e18 0\n", "5:15: found '1e18', expected the number of atoms of frame 0"},
            {v3000 + "M  V30 COUNTS 99999999999 0\n", "5:15: found '99999999999', expected the number of atoms of frame 0"},
            {v3000 + "M  V30 COUNTS 2000000000 0\nM  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0\n",
             "8:1: the text ends, expected atom 2 of 2000000000 of frame 0"},
            {v3000 + "M  V30 COUNTS 1 0\nM  V30 BEGIN ATOM\nM  V30 END ATOM\n",
             "7:16: the line ends, expected the x of atom 1 of 1"},
        });
}

}  // namespace sphereview

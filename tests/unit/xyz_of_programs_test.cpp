// XYZ of programs that write more, less or something else than the format has.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/elements.hpp"
#include "formats/scene_format.hpp"
#include "formats/sphere_data.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

using Lines = std::vector<std::string>;

SphereData read_programs_xyz(const std::string& text, const DataOptions& options = {}) { return read_xyz(text, "a.xyz", options); }

}  // namespace

TEST(XyzOfPrograms, AFaultBehindTheWantedFrameIsOnlySaid) {
    struct Case {
        const char* text;
        std::int64_t frames;
        const char* warning;
    };
    for (const auto& [text, frames, warning] : std::vector<Case>{
             // what a killed simulation leaves
             {"2\nframe 0\nH 0 0 0\nH 0.74 0 0\n2\nframe 1, cut short\nH 0 0 0\n", 1,
              "8:1: the text ends, expected atom 2 of 2 of frame 1; what follows frame 0 is passed over"},
             {"1\n\nH 0 0 0\n1\n\nH 0 0 0\n1", 2,
              "7:2: the text ends, expected the comment of frame 2; what follows frame 1 is passed over"},
             {"1\n\nH 0 0 0\n1\n\nH 0 0 0\n1\nc\n", 2,
              "9:1: the text ends, expected atom 1 of 1 of frame 2; what follows frame 1 is passed over"},
             // QM9
             {"3\nown\nO 0.0 0.0 0.1173\nH 0.0 0.7572 -0.4692\nH 0.0 -0.7572 -0.4692\n1600.1 3700.2 3800.3\nO "
              "O\nInChI=1S/H2O/h1H2\n",
              1,
              "6:1: found '1600.1', expected the number of atoms of frame 1, a whole number; what follows frame 0 is passed over"},
             {"3\nown\nO 0 0 0.1173\nH 0 0.7572 -0.4692\nH 0 -0.7572 -0.4692\nVEC1 5 0 0\nVEC2 0 5 0\nVEC3 0 0 5\n", 1,
              "6:1: found 'VEC1' behind the atoms; the lattice is passed over"},
             // one more atom than was said, by its symbol and by its number
             {"1\n\nH 1 2 3\nH 4 5 6\n", 1,
              "4:1: found 'H', expected the number of atoms of frame 1, a whole number; what follows frame 0 is passed over"},
             {"1\n\n1 1 2 3\n8 4 5 6\n1 7 8 9\n", 1,
              "4:3: found '4', expected the end of the line after the number of atoms of frame 1; what follows frame 0 is passed "
              "over"},
         }) {
        const SphereData data = read_programs_xyz(text);
        EXPECT_EQ(data.frames, frames) << text;
        EXPECT_EQ(data.warnings, (Lines{std::string("a.xyz:") + warning}));
        EXPECT_FALSE(data.scene.spheres.empty());
    }
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1\n\nH 0 0 0\n2\n\nH 0 0 0\n", {.frame = 1}); }),
              "a.xyz:7:1: the text ends, expected atom 2 of 2 of frame 1");
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1\n\nH 0 0 0\nend\n1\n\nH 0 0 0\n", {.frame = 1}); }),
              "a.xyz:4:1: found 'end', expected the number of atoms of frame 1, a whole number");
    EXPECT_TRUE(read_programs_xyz("1\n\nH 0 0 0\n").warnings.empty());
}

TEST(XyzOfPrograms, FramesOfUtf16AreOneFrameWithAWord) {
    const auto utf16 = [](const std::string& text) {
        std::string units = "\xFF\xFE";
        for (const char c : text) units.append(1, c).append(1, '\0');
        return units;
    };
    const std::string frame = "1\n\nH 1 0 0\n";
    const SphereData data = read_programs_xyz(utf16(frame + "1\n\nH 2 0 0\n"), {.frame = 1});
    EXPECT_EQ(data.scene.spheres.at(0).center.x, 2.0);
    EXPECT_EQ(data.warnings, (Lines{"a.xyz: a text in UTF-16 counts as one frame, though it has 2: --frame N shows each; saved as "
                                    "UTF-8 it has them all"}));
    EXPECT_TRUE(read_programs_xyz(utf16(frame)).warnings.empty());
}

TEST(XyzOfPrograms, OfTinkerHasNoComment) {
    const std::string atoms =
        "     1  OW     1.000000    2.000000    3.000000     1     2\n     2  CT     4.0    5.0    6.0     2     1\n";
    const std::string box = "   18.6   18.6   18.6   90.0   90.0   90.0\n";
    for (const std::string& frame : {"     2  water 1\n" + atoms, "2\n" + atoms, "2 water\n" + box + atoms}) {
        const SphereData data = read_programs_xyz(frame + frame, {.frame = 1, .all_properties = true});
        EXPECT_EQ(data.frames, 2) << frame;
        EXPECT_TRUE(data.warnings.empty()) << frame;
        EXPECT_EQ(centers_of(data.scene), (Centers{{1, 2, 3}, {4, 5, 6}})) << frame;
        EXPECT_EQ(data.scene.spheres[0].color, find_element("O")->color);
        EXPECT_EQ(data.scene.spheres[1].color, find_element("C")->color);
        EXPECT_EQ(data.scene.names.at(1), "CT");
        EXPECT_EQ(data.property_names, (Lines{"atom", "type"}));
        PartOfFile part{.frames = 1};
        EXPECT_EQ(step_over_xyz(frame, true, "a", part), frame.size());
    }
    // An atom's line may be a comment.
    EXPECT_EQ(read_programs_xyz("1\n1 O 2 3\nH 1 0 0\n").scene.spheres.at(0).center.x, 1.0);
}

TEST(XyzOfPrograms, OfMopacHasAFlagBehindEachCoordinate) {
    const std::string said = "a.xyz: holds MOPAC's flags behind each coordinate; they are passed over";
    const std::string frame = "3\n PM7\n C -0.748 0 0.015 0 0.024 0\n O 0.5 1 -2.25 -1 3.0 +1\n 1 1. 1 2. 1 3. 0\n";
    const Centers centers = {{-0.748, 0.015, 0.024}, {0.5, -2.25, 3}, {1, 2, 3}};
    for (const std::string& before : {std::string(), frame}) {
        const SphereData data = read_programs_xyz(before + frame, {.frame = before.empty() ? 0 : 1, .all_properties = true});
        EXPECT_EQ(centers_of(data.scene), centers);
        EXPECT_EQ(data.warnings, Lines{said});
        EXPECT_EQ(data.property_names, Lines{"element"});
        EXPECT_EQ(data.scene.names.at(2), "H");
    }
    EXPECT_EQ(read_programs_xyz("1\n\nC 1.0 0 2.0 0 3.0 0 -0.25\n").property_names, (Lines{"element", "column8"}));

    // A last line may be cut within its flags or its coordinates.
    const std::string cut = frame.substr(0, frame.size() - 3);
    EXPECT_EQ(centers_of(read_programs_xyz(cut).scene), centers);
    EXPECT_EQ(read_programs_xyz(cut).warnings,
              (Lines{said, "a.xyz:5:16: the text ends, expected the whole line of the last atom of frame 0"}));
    EXPECT_EQ(read_programs_xyz(frame + cut).frames, 1);
    EXPECT_EQ(message_of<InputError>([&] { read_programs_xyz(frame.substr(0, frame.size() - 6)); }),
              "a.xyz:5:13: the line ends, expected the z of atom 3 of 3");
    EXPECT_TRUE(read_programs_xyz("1\n\nC 1 0 0\n" + frame, {.frame = 0}).warnings.empty());

    // What is no flag, or no coordinate, in one line.
    for (const std::string other : {"C 1.0 0 2.0 0 3.0 2", "C 1.0 0 2.0 0 3.0 0.0", "C 1.0 0 2 0 3.0 0", "C 1.0 0 2.0 0 3.0"}) {
        const SphereData data = read_programs_xyz("2\n\nC 0.5 1 0.5 1 0.5 1\n" + other + "\n");
        EXPECT_EQ(data.scene.spheres.at(0).center, glm::dvec3(0.5, 1, 0.5)) << other;
        EXPECT_TRUE(data.warnings.empty()) << other;
    }
    EXPECT_TRUE(read_programs_xyz("2\n\nC 0.5 1 0.5 1 0.5 1\nC 1 0 0").warnings.empty());
    const std::string named = "1\nProperties=species:S:1:pos:R:3:velo:R:3\nC 0.5 1 0.5 1 0.5 1\n";
    EXPECT_EQ(read_programs_xyz(named).scene.spheres.at(0).center, glm::dvec3(0.5, 1, 0.5));
}

TEST(XyzOfPrograms, NumbersBelowTheCommentOfLammpsAreTypes) {
    std::string atoms;
    for (int i = 0; i < 12; ++i) atoms += std::to_string(i) + " " + std::to_string(2 * i) + " 0 0\n";
    const std::string comment = "Atoms. Timestep: 10\n";
    const DataOptions all{.all_properties = true};
    const SphereData data = read_programs_xyz("12\n" + comment + atoms, all);
    // The same atoms in a dump with columns.
    const SphereData dump =
        read_lammps("ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n12\nITEM: ATOMS type x y z\n" + atoms, "a.xyz", all);
    EXPECT_EQ(data.scene.spheres, dump.scene.spheres);
    EXPECT_EQ(data.scene.names, dump.scene.names);
    EXPECT_EQ(data.scene.properties, dump.scene.properties);
    EXPECT_EQ(data.property_names, Lines{"type"});
    EXPECT_EQ(data.warnings, dump.warnings);
    EXPECT_EQ(data.radius_of_points, 0.5);
    EXPECT_EQ(read_programs_xyz("12\n" + comment + atoms, {.radius = 3.0}).scene.spheres.at(7).radius, 3.0);

    const Color oxygen = find_element("O")->color;
    EXPECT_EQ(read_programs_xyz("1\nAtoms. Timestep\n8 0 0 0\n").scene.spheres.at(0).color, oxygen);
    const SphereData symbols = read_programs_xyz("2\n" + comment + "O 0 0 0\nH 2 0 0\n");
    EXPECT_EQ(symbols.scene.spheres.at(0).color, oxygen);
    EXPECT_EQ(symbols.scene.spheres.at(0).radius, find_element("O")->radius);
    EXPECT_EQ(symbols.property_names, Lines{"element"});
}

TEST(XyzOfPrograms, ALastLineMayBeCutShort) {
    const std::string first = "2\n\nH 0 0 0\nH 0.5 0 0\n";
    const std::string more = "2\nProperties=species:S:1:pos:R:3:forces:R:3\nH 0 0 0 1 1 1\n";
    const std::string said = "the text ends, expected the whole line of the last atom of frame ";
    for (const std::string cut : {"H", "H 0.1 0."}) {
        const SphereData data = read_programs_xyz(first + "2\n\nH 0 0 0\n" + cut);
        EXPECT_EQ(data.frames, 1) << cut;
        EXPECT_EQ(data.warnings,
                  (Lines{"a.xyz:8:" + std::to_string(cut.size() + 1) + ": " + said + "1; what follows frame 0 is passed over"}));
    }
    const SphereData forces = read_programs_xyz(more + "H 1 0 0 1 1");
    EXPECT_EQ(forces.scene.spheres.size(), 2U);
    EXPECT_EQ(forces.warnings, (Lines{"a.xyz:4:12: " + said + "0"}));
    EXPECT_TRUE(read_programs_xyz(more + "H 1 0 0 1 1 1").warnings.empty());

    // What still reads as an atom: as places are written alike, one with fewer decimals is cut.
    std::string many = "20\n\n";
    std::string vary = many;
    for (int i = 0; i < 19; ++i) {
        many += "H " + std::to_string(i) + ".1250 0.2500 1.5000\n";
        vary += "H " + std::to_string(i) + ".125 0.25 1.5" + (i == 9 ? "00" : "") + "\n";
    }
    for (const std::string cut : {"H 1.2500 0.2500 1.5", "H 1.2500 0.2500 1", "H 1.2500 0.2500 1."}) {
        EXPECT_EQ(read_programs_xyz(many + cut).warnings.size(), 1U) << cut;
        EXPECT_TRUE(read_programs_xyz(many + cut + "\n").warnings.empty()) << cut;
        EXPECT_TRUE(read_programs_xyz(vary + cut).warnings.empty()) << cut;
        EXPECT_EQ(read_programs_xyz(first + many + cut).frames, 1) << cut;
    }
    EXPECT_TRUE(read_programs_xyz(many + "H 1.2500 0.2500 1.5000").warnings.empty());
    for (const std::string cut : {"H 1.2500 0.2500 -", "H 1.2500 0.2500 -1.5", "H 1.2500 0.2500 x"})
        EXPECT_EQ(read_programs_xyz(first + many + cut).frames, 1) << cut;
    EXPECT_TRUE(read_programs_xyz("2\n\nH 0.1 0.2 0.3\nH 0 0 0").warnings.empty());
}

TEST(XyzOfPrograms, ALastLineMayBeShorterThanTheOthers) {
    const std::string first = "1\n\nH 0 0 0\n";
    struct Case {
        const char* column;  // of all atoms but the last
        const char* last;
    };
    for (const auto& [column, last] :
         std::vector<Case>{{"0.5000", "nan"}, {"0.5000", "5e-05"}, {"0.5", "10"}, {"0.25", "1"}, {"7", "1"}}) {
        std::string frame = "20\n\n";
        for (int i = 0; i < 19; ++i) frame += "H " + std::to_string(i) + ".1250 0.2500 1.5000 " + column + "\n";
        frame += std::string("H 1.2500 0.2500 1.5000 ") + last;
        const SphereData data = read_programs_xyz(first + frame, {.frame = 1});
        EXPECT_EQ(data.frames, 2) << last;
        EXPECT_TRUE(data.warnings.empty()) << last;
        EXPECT_EQ(read_programs_xyz(first + frame).frames, 2) << last;
    }
    std::string frame = "20\n\n";
    for (int i = 0; i < 19; ++i) frame += "H " + std::to_string(i) + ".1250 0.2500 1.5000\n";
    EXPECT_EQ(read_programs_xyz(first + frame + "H 1.2500 0.2500 nan").frames, 2);
}

TEST(XyzOfPrograms, LinesThatAreNoAtomsMayStandBetweenFrames) {
    const std::string text = "1\n\nH 0 0 0\nVEC1 5 0 0\nVEC2 0 5 0\nVEC3 0 0 5\n1\n\nH 1 0 0\n>\n1\n\nH 2 0 0\n";
    const SphereData data = read_programs_xyz(text, {.frame = 2});
    EXPECT_EQ(data.frames, 3);
    EXPECT_EQ(data.scene.spheres.at(0).center.x, 2.0);
}

TEST(XyzOfPrograms, MoreMayStandBehindTheNumberOfAtoms) {
    for (const char* line : {"1 some words", "1 -76.4 Hartree", "1 10.0 10.0 10.0", "1\tangstrom", "1 #"}) {
        const SphereData data = read_programs_xyz(std::string(line) + "\nc\nH 0 0 0\n" + line + "\nc\nH 1 0 0\n");
        EXPECT_EQ(data.frames, 2) << line;
        EXPECT_EQ(data.scene.spheres.size(), 1U) << line;
        EXPECT_TRUE(data.warnings.empty()) << line;
    }
    EXPECT_EQ(detect_format("3 atoms\nwater\nO 0 0 0\nH 1 0 0\nH 0 1 0\n", "").name, "XYZ");
    EXPECT_EQ(detect_format("1 2 3\n4 5 6\n7 8 9\n", "").name, "text");
    EXPECT_EQ(detect_format("1 255 0 0\n1 2 3\n4\n", "").name, "text");
}

TEST(XyzOfPrograms, ExponentsAreThoseOfOtherLanguages) {
    EXPECT_EQ(centers_of(read_programs_xyz("2\nc\nO 1.0D+00 -2.5d-1 3.*^2\nO -1.5*^-6 1.D0 0.25-102\n").scene),
              (std::vector<glm::dvec3>{{1.0, -0.25, 300.0}, {-1.5e-6, 1.0, 0.25e-102}}));
    EXPECT_EQ(centers_of(read_programs_xyz("1\nc\nO 1.0+01 -2.5-01 0\n").scene), (std::vector<glm::dvec3>{{10.0, -0.25, 0.0}}));
    for (const std::string wrong :
         {"1.0D", "1.0*^", "1.0Dx", "1D1D1", "D1", "*^1", "1-2", "1.0-1", "1.0D1.5", "0x1p3", "1.0 *^2"}) {
        EXPECT_THROW(read_programs_xyz("1\nc\nO " + wrong + " 0\n"), InputError) << wrong;
    }
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1\nc\nO 1.0D+400 0 0\n"); }),
              "a.xyz:3:3: found '1.0D+400', expected the x of atom 1 of 1, a number that a double can hold (at most 1.8e308)");
}

TEST(XyzOfPrograms, NamesOfPropertiesMayHoldColons) {
    const Scene scene = read_programs_xyz("2\nProperties=species:S:1:pos:R:3:mtt::aux:R:1\nO 0 0 0 1\nH 0 0 1 2\n").scene;
    EXPECT_EQ(centers_of(scene), (std::vector<glm::dvec3>{{0, 0, 0}, {0, 0, 1}}));
    EXPECT_EQ(read_programs_xyz("1\nProperties=a::b::c:R:1:pos:R:3\n9 1 2 3\n").scene.spheres.at(0).center, glm::dvec3(1, 2, 3));
}

TEST(XyzOfPrograms, PositionsMayBeFlat) {
    const Scene scene = read_programs_xyz("1\nProperties=pos:R:2:species:S:1\n1 2 O\n").scene;
    EXPECT_EQ(scene.spheres.at(0).center, glm::dvec3(1, 2, 0));
    EXPECT_EQ(scene.names.at(0), "O");
}

TEST(XyzOfPrograms, MayBeNothingButPoints) {
    const std::vector<glm::dvec3> three = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}};
    for (const char* text :
         {"0.1 0.2 0.3\n0.4 0.5 0.6\n0.7 0.8 0.9\n", "# x y z\n0.1 0.2 0.3\n\n0.4\t0.5\t0.6\n // c\n 0.7 0.8 0.9",
          "//X Y Z i\r\n0.1 0.2 0.3 7\r\n0.4 0.5 0.6 8\r\n0.7 0.8 0.9 9\r\n", "0.1 0.2 0.3\r0.4 0.5 0.6\r0.7 0.8 0.9"}) {
        const SphereData data = read_programs_xyz(text);
        EXPECT_EQ(centers_of(data.scene), three) << text;
        EXPECT_EQ(data.frames, 1);
        EXPECT_TRUE(data.scene.names.empty());
    }
    EXPECT_EQ(centers_of(read_programs_xyz("1 2 3\n4 5 6\n").scene), (std::vector<glm::dvec3>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read_programs_xyz("1 2 3\n", {.radius = 2.5}).scene.spheres.at(0).radius, 2.5);
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1 2 3\n4 5 6\n7 8 9\n10 11\n"); }),
              "a.xyz:4:6: the line ends, expected z");
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1 2 3\n4 5 6\n7 8 9\n1 x 1\n"); }),
              "a.xyz:4:3: found 'x', expected y, a number");
    EXPECT_EQ(message_of<InputError>([] { read_programs_xyz("1 2 3\n", {.frame = 1}); }),
              "a.xyz: found 1 frame, number 0, expected frame 1");
}

TEST(XyzOfPrograms, PointsMayHaveAllThatATableHas) {
    const std::vector<glm::dvec3> two = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
    for (const char* text :
         {"nan nan nan\n0.1 0.2 0.3\n0.4 0.5 0.6\n", "0.1 0.2 0.3\n0.4 0.5 0.6\nnan nan nan\n", "2\n0.1 0.2 0.3\n0.4 0.5 0.6\n",
          "2\n0.1 0.2 0.3 7.5\n0.4 0.5 0.6 7.5\n", "x y z\n0.1 0.2 0.3\n0.4 0.5 0.6\n", "x,y,z\n0.1,0.2,0.3\n0.4,0.5,0.6\n",
          "0.1,0.2,0.3\n0.4,0.5,0.6\n", "1.0D-01 0.2 0.3\n0.4 0.5 0.6\n"}) {
        EXPECT_EQ(centers_of(read_programs_xyz(text).scene), two) << text;
        PartOfFile part;
        EXPECT_EQ(step_over_xyz(text, true, "a.xyz", part), std::string(text).size()) << text;
    }
    const SphereData colored = read_programs_xyz("0.1 0.2 0.3 255 0 0 7\n0.4 0.5 0.6 0 255 0 8\n", {.all_properties = true});
    EXPECT_EQ(colored.scene.spheres.at(0).color, (Color{255, 0, 0}));
    EXPECT_EQ(colored.property_names, Lines{"column7"});
    // Frames of atoms are none of these.
    for (const char* text : {"2\n1 2 3\n6 0 0 0\n8 1 0 0\n", "2\n\n6 0 0 0\n8 1 0 0\n", "2\n1 2 3 4\n6 0 0 0\n8 1 0 0\n",
                             "2\nx y z\nC 0 0 0\nO 1 0 0\n"}) {
        EXPECT_EQ(read_programs_xyz(text).scene.spheres.at(1).radius, find_element("O")->radius) << text;
    }
}

TEST(XyzOfPrograms, AtomsWithoutCoordinatesAreLeftOutAndCounted) {
    const SphereData data = read_programs_xyz("4\nc\nH nan nan nan\nO 3 4 5\nX inf 0 0\nX 6 7 8\n");
    EXPECT_EQ(centers_of(data.scene), (std::vector<glm::dvec3>{{3, 4, 5}, {6, 7, 8}}));
    EXPECT_EQ(data.scene.names, (std::map<std::uint32_t, std::string>{{0, "O"}, {1, "X"}}));
    EXPECT_EQ(data.warnings,
              (Lines{"a.xyz: 2 atoms have no coordinates and are left out",
                     "a.xyz: found 1 virtual site or dummy, which is no atom; shown small, or not with --no-virtual"}));
    const Scene few = read_programs_xyz("3\nProperties=species:S:1:pos:R:3:q:R:1\nX 0 0 0 1\nO 3 4 NaN 2\nO 3 4 5 3\n",
                                        {.virtual_sites = false, .all_properties = true})
                          .scene;
    EXPECT_EQ(centers_of(few), (std::vector<glm::dvec3>{{3, 4, 5}}));
    EXPECT_EQ(std::get<std::vector<double>>(few.properties.at(1).values), std::vector<double>{3});
    EXPECT_EQ(read_programs_xyz("2\nProperties=species:S:1:pos:R:2\nH nan 0\nO 3 4\n").scene.spheres.size(), 1U);
}

TEST(XyzOfPrograms, AtomsOfNoKindArePoints) {
    for (const char* columns : {"pos:R:3", "pos:R:3:type:I:1", "pos:R:3:radius:R:1"}) {
        const SphereData data =
            read_programs_xyz("3\nProperties=" + std::string(columns) + "\n0 0 0 0\n20000 0 0 0\n0 20000 0 0\n");
        EXPECT_EQ(data.scene.spheres.at(0).radius, 5000.0) << columns;
        EXPECT_EQ(data.scene.spheres.at(0).color, (Color{255, 255, 255})) << columns;
        EXPECT_EQ(data.radius_of_points, 5000.0);
        EXPECT_EQ(data.warnings.size(), 1U);
    }
    EXPECT_EQ(read_programs_xyz("2\nProperties=pos:R:3\n0 0 0\n8 0 0\n", {.radius = 3.0}).scene.spheres.at(0).radius, 3.0);
    EXPECT_EQ(read_programs_xyz("2\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n8 0 0 0\n").scene.spheres.at(0).radius, 1.0);
}

TEST(XyzOfPrograms, MayBeUtf16) {
    using namespace std::string_literals;
    std::string bytes = "\xFF\xFE"s;
    for (const char c : "2\nc\nH 0 0 0\nO 1 0 0\n"s) bytes += {c, '\0'};
    EXPECT_EQ(read_programs_xyz(bytes).scene.names.at(1), "O");
    EXPECT_EQ(read_programs_xyz(bytes.substr(2)).scene.names.at(1), "O");
    EXPECT_EQ(detect_format(bytes, "a.xyz").name, "XYZ");
    PartOfFile part;
    EXPECT_EQ(step_over_xyz(bytes, false, "a.xyz", part), std::nullopt);
    EXPECT_EQ(step_over_xyz(bytes, true, "a.xyz", part), bytes.size());
}

TEST(XyzOfPrograms, ARadiusThatIsNoneIsTheUsualOne) {
    const double usual = find_element("Si")->radius;
    const std::string head = "2\nProperties=species:S:1:pos:R:3:radius:R:1\n";
    for (const std::string radius : {"0", "0.0", "-1", "nan", "inf", "1e999", "NA", "nan(0x7)"}) {
        const Scene scene = read_programs_xyz(head + "Si 0 0 0 " + radius + "\nSi 2 0 0 0.5\n").scene;
        EXPECT_EQ(scene.spheres.at(0).radius, usual) << radius;
        EXPECT_EQ(scene.spheres.at(1).radius, 0.5) << radius;
    }
    EXPECT_EQ(read_programs_xyz(head + "Si 0 0 0 0\nSi 2 0 0 0\n", {.radius = 3.0}).scene.spheres.at(0).radius, 3.0);
}

TEST(XyzOfPrograms, ColoursAreWhatTheColumnHolds) {
    const auto colors = [](const std::string& type, const std::string& first, const std::string& second) {
        const Scene scene = read_programs_xyz("2\nProperties=species:S:1:pos:R:3:color:" + type + ":3\nO 0 0 0 " + first +
                                              "\nO 1 0 0 " + second + "\n")
                                .scene;
        return std::vector<Color>{scene.spheres.at(0).color, scene.spheres.at(1).color};
    };
    const Color oxygen = find_element("O")->color;
    EXPECT_EQ(colors("R", "1 0.5 0", "0 0 0.2"), (std::vector<Color>{{255, 128, 0}, {0, 0, 51}}));
    EXPECT_EQ(colors("R", "255.0 128.0 0", "1 1 1"), (std::vector<Color>{{255, 128, 0}, {1, 1, 1}}));
    EXPECT_EQ(colors("I", "255 128 0", "1 1 1"), (std::vector<Color>{{255, 128, 0}, {1, 1, 1}}));
    EXPECT_EQ(colors("I", "1 0 0", "0 1 0"), (std::vector<Color>{{255, 0, 0}, {0, 255, 0}}));  // OVITO's pure colours
    EXPECT_EQ(colors("I", "2 0 0", "0 1 0"), (std::vector<Color>{{2, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(colors("I", "65535 32896 0", "0 257 0"), (std::vector<Color>{{255, 128, 0}, {0, 1, 0}}));
    EXPECT_EQ(colors("R", "1.0000001 0 0", "0 1 0"), (std::vector<Color>{{255, 0, 0}, {0, 255, 0}}));
    EXPECT_EQ(colors("R", "nan -1 0", "0 1 0"), (std::vector<Color>{oxygen, {0, 255, 0}}));
}

TEST(XyzOfPrograms, RadiiAndColoursOfAnotherKindArePassedOver) {
    const Scene scene =
        read_programs_xyz("1\nProperties=species:S:1:radius:R:3:color:R:1:colors:S:3:pos:R:3\nO 9 9 9 1 a b c 1 2 3\n").scene;
    EXPECT_EQ(scene.spheres.at(0).center, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.spheres.at(0).radius, find_element("O")->radius);
    EXPECT_EQ(scene.spheres.at(0).color, find_element("O")->color);
    const Scene opaque = read_programs_xyz("1\nProperties=color:R:4:pos:R:3\n1 0 0 0.5 1 2 3\n").scene;
    EXPECT_EQ(opaque.spheres.at(0).center, glm::dvec3(1, 2, 3));
    EXPECT_EQ(opaque.spheres.at(0).color, (Color{255, 0, 0}));
}

TEST(XyzOfPrograms, WhatIsNoAtomIsSmallOrLeftOut) {
    std::string text = "3000\n\n";
    for (int i = 0; i < 1000; ++i) text += "X 0 0 0\nO " + std::to_string(i) + " 0 0\nBq 9 9 9\n";
    const SphereData with = read_programs_xyz(text);
    EXPECT_EQ(with.warnings,
              (Lines{"a.xyz: found 2,000 virtual sites or dummies, which are no atoms; shown small, or not with --no-virtual"}));
    EXPECT_EQ(with.scene.spheres.at(0).radius, virtual_site().radius);
    const Scene large =
        read_programs_xyz("3\nProperties=species:S:1:pos:R:3:radius:R:1\nX 0 0 0 5\nO 1 0 0 0.6\nX 0 0 0 0.1\n").scene;
    EXPECT_EQ(large.spheres.at(0).radius, virtual_site().radius);
    EXPECT_EQ(large.spheres.at(2).radius, 0.1);
    EXPECT_EQ(read_programs_xyz("2\n\nO-Bq 0 0 0\nO: 1 0 0\n").warnings,
              (Lines{"a.xyz: found 2 virtual sites or dummies, which are no atoms; shown small, or not with --no-virtual"}));
    const SphereData without = read_programs_xyz(text, {.virtual_sites = false});
    EXPECT_EQ(without.warnings, (Lines{"a.xyz: found 2,000 virtual sites or dummies, which are no atoms; left out"}));
    ASSERT_EQ(without.scene.spheres.size(), 1000U);
    for (std::size_t i = 0; i < 1000; ++i) {
        EXPECT_EQ(without.scene.spheres[i].center.x, static_cast<double>(i));
        EXPECT_EQ(without.scene.names.at(static_cast<std::uint32_t>(i)), "O");
    }
}

}  // namespace sphereview

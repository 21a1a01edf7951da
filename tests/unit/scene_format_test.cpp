#include "formats/scene_format.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/text.hpp"
#include "support/folders.hpp"
#include "support/spheres.hpp"
#include "support/trials.hpp"
#include "unit/message_of.hpp"
#include "unit/random_scene.hpp"
#include "unit/scene_difference.hpp"

namespace sphereview {

TEST(DetectFormat, BelievesTheContentBeforeTheName) {
    for (const char* content : {"0", "  \n 3 ",
                                "\xEF\xBB\xBF"
                                "1",
                                "+1", "-1", ".5", "1\n# not a comment here\na = 1"}) {
        EXPECT_EQ(detect_format(content, "s.toml").name, "text") << content;
    }
    for (const char* content :
         {"# a comment", "\xEF\xBB\xBF\n# a comment", "# a comment\r\n\n #b\rspheres = '0'", "[camera]", "[[sphere]]",
          "background = 'white'", "camera.eye = [0, 0, 0]", "\"background\"=\"white\"", "\r\n  spheres = '0'", "1 = 2"}) {
        EXPECT_EQ(detect_format(content, "s.txt").name, "TOML") << content;
    }
}

// Zero bytes and Ctrl-Z behind the text.
TEST(EndMarks, AreNoPartOfAText) {
    using namespace std::string_literals;
    std::vector<std::pair<std::string, std::string>> files = {
        {"a.txt", "1\n255 0 0\n0 0 300\n20\n"},
        {"a.toml", "[[sphere]]\ncolor = [1, 2, 3]\ncenter = [0, 0, 300]\nradius = 3\n"},
        {"a.xyz", "1\n\nO 0 0 1\n"},
        {"points.xyz", "0 0 1\n1 2 3\n4 5 7\n"},
        {"a.csv", "x,y,z\n0,0,0\n1,2,3\n"},
        {"a.pdb", "ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N\n"},
        {"a.lammpstrj", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z\n1 0 0 5\n"},
        {"a.gro", "t\n1\n    1SOL     OW    1   1.000   1.000   1.000\n 1 1 1\n"},
        {"POSCAR", "Na\n1\n1 0 0\n0 1 0\n0 0 1\nNa\n1\nDirect\n0 0 0\n"},
        {"a.sdf", "\n\n\n  1  0\n0 0 0 H\nM  END\n$$$$\n"},
        {"a.pqr", "ATOM 1 N A 1 0 0 0 0 1\n"},
        {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n0 1 0\n"}};
#ifndef WITHOUT_GEMMI
    files.emplace_back("a.cif", "data_a\nloop_\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 2 3\n");
#endif
    for (const auto& [name, text] : files) {
        const Scene scene = parse_scene(text, name);
        EXPECT_FALSE(scene.spheres.empty()) << name;
        for (const std::string& end : {"\0"s, "\0\0\0"s, "\x1A"s, "\x1A\0"s}) {
            EXPECT_EQ(parse_scene(text + end, name), scene) << name;
            EXPECT_EQ(parse_scene(text.substr(0, text.size() - 1) + end, name), scene) << name;
        }
    }
    EXPECT_EQ(without_end_marks("x\0\n\0"s), "x\0\n\0"s) << "UTF-16";
    EXPECT_THROW(parse_scene("x,y,z\n0,0,\0\n1,2,3\n"s, "a.csv"), InputError);
    EXPECT_EQ(message_of<InputError>([] { detect_format("\0\0\0\0"s, "a.txt"); }).substr(0, 25), "a.txt: found binary data,");
}

TEST(DetectFormat, BelievesTheNameWhereTheContentIsUnclear) {
    for (const char* content : {"", " \n", "hello", "\x89PNG", "\xEF\xBB\xBF", "is 2 + 2 = 4?"}) {
        for (const char* name : {"s.toml", "S.TOML", "a.txt/s.Toml"}) {
            EXPECT_EQ(detect_format(content, name).name, "TOML") << content;
        }
        for (const char* name : {"s.txt", "s", "toml", "s.toml.txt", "stdin"}) {
            EXPECT_EQ(detect_format(content, name).name, "text") << content;
        }
    }
}

TEST(DetectFormat, KnowsDataByItsName) {
    for (const auto& [name, format] : std::vector<std::pair<const char*, const char*>>{{"a.xyz", "XYZ"},
                                                                                       {"b/a.ExtXYZ", "XYZ"},
                                                                                       {"a.csv", "CSV"},
                                                                                       {"a.pdb", "PDB"},
                                                                                       {"pdb1crn.ent.gz", "PDB"},
                                                                                       {"a.cif", "mmCIF"},
                                                                                       {"a.mmCIF.GZ", "mmCIF"},
                                                                                       {"a.csv.gz", "CSV"}}) {
        EXPECT_EQ(format_of_name(name).name, format) << name;
        for (const char* content : {"", "1 1 2 3 4 5 6 7", "[camera]", "# a comment"}) {
            EXPECT_EQ(detect_format(content, name).name, format) << name;
        }
    }
    EXPECT_EQ(format_of_name("a.toml.gz").name, "TOML");
    EXPECT_EQ(format_of_name("a.txt.gz").name, "text");
    EXPECT_EQ(format_of_name("a.gz").name, "text");
}

TEST(DetectFormat, KnowsDataOfAnotherNameByItsContent) {
    const std::vector<std::pair<std::string, const char*>> cases = {
        {"3\nwater\nO 0 0 0\nH 0 0 1\nH 0 1 0\n", "XYZ"},
        {" 1 \r\n\r\n  Fe2+ 1 2 3\r\n", "XYZ"},
        {"1\r\rH 0 0 0", "XYZ"},
        {"1\nAtoms. Timestep: 0\n1 0 0 0\n", "XYZ"},
        {"1\n-76.4\nH 0 0\n", "XYZ"},
        {"1\nProperties=pos:R:3\n0 0 0\n", "XYZ"},
        {"x,y,z\n1,2,3\n", "CSV"},
        {"\xEF\xBB\xBF\n\"Name\";\"Z\";\"Y\";\"X\"\n", "CSV"},
        {"# x, y, z\n", "CSV"},
        {"HEADER    PLANT PROTEIN                           30-APR-81   1CRN\n", "PDB"},
        {"ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79           N\n", "PDB"},
        {"REMARK   1 R = 0.1\n", "PDB"},
        {"data_1CRN\n#\nloop_\n", "mmCIF"},
        {"# written by a program\ndata_1CRN\n_entry.id = 1\n", "mmCIF"},
    };
    for (const auto& [content, format] : cases) {
        for (const char* name : {"stdin", "a.dat", "xyz"}) EXPECT_EQ(detect_format(content, name).name, format) << content;
    }
    // Neither data nor anything else where the name says what it is.
    EXPECT_EQ(detect_format("3\nwater\nO 0 0 0\n", "s.txt").name, "text");
    EXPECT_EQ(detect_format("x,y,z\n", "s.toml").name, "TOML");
    // Scenes that look a little like data.
    for (const char* content :
         {"1\n255 0 0\n1 2 3 4\n", "2\n255 0 0\nhello 2 3 4\n", "1\n255 0 0 1 2 3 4\n", "1\n\n255 0 0 1 2 3 4\n",
          "1\n255 0 zero\n1 2 3 4\n", "1\nred\n0.5 2 3 4\n", "3\n", "2 3\na\nH 0 0 0\n", "-1\na\nH 0 0 0\n"}) {
        EXPECT_EQ(detect_format(content, "stdin").name, "text") << content;
    }
    for (const char* content : {"x = 1", "data_x = 1", "TITLE = 'x'", "# x, y", "[x.y.z]"}) {
        EXPECT_EQ(detect_format(content, "stdin").name, "TOML") << content;
    }
}

TEST(DetectFormat, GuessesAMisspeltEndingWhereNothingElseTells) {
    EXPECT_EQ(message_of<InputError>([] { detect_format("hello", "a.b/t.cvs.gz"); }),
              "a.b/t.cvs.gz: found the ending '.cvs' and nothing that shows a format, expected the ending of one; did you mean "
              "'.csv'?");
    EXPECT_EQ(detect_format("hello", "a.d/xyz").name, "text");
    EXPECT_EQ(detect_format("hello", "a.dat").name, "text");
    EXPECT_EQ(detect_format("x,y,z\n1,2,3\n", "t.cvs").name, "CSV");
}

TEST(ParseScene, ReadsEitherFormatWhateverTheName) {
    const Scene text = parse_scene("1 1 2 3 4 5 6 7", "s.toml");
    const Scene toml = parse_scene("[[sphere]]\ncolor = [1, 2, 3]\ncenter = [4, 5, 6]\nradius = 7\n", "s.txt");
    EXPECT_EQ(text, toml);
    ASSERT_EQ(text.spheres.size(), 1U);
    EXPECT_EQ(text.spheres[0], (Sphere{{4, 5, 6}, 7, {1, 2, 3}, false}));
}

TEST(ParseScene, SaysThatTheTextFormatHasNoComments) {
    EXPECT_EQ(detect_format("# a comment\nhello", "s.toml").name, "TOML");
    for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
             {"# two\n2 1 2 3", "1:1"}, {"\xEF\xBB\xBF\n  # two\n # b\n2", "2:3"}, {"# hello\nhello", "1:1"}}) {
        EXPECT_EQ(
            message_of<InputError>([&text = text] { parse_scene(text, "s.txt"); }),
            "s.txt:" + place + ": found '#', expected the number of spheres: only TOML has comments, the text format has none");
    }
}

TEST(SceneFormats, AreListedForHelpDialogsAndMessages) {
    EXPECT_EQ(listed(format_names(), "or"), "text, TOML, XYZ, CSV, PDB, mmCIF, LAMMPS, GROMACS, POSCAR, SDF, PQR or PLY");
    EXPECT_EQ(listed(format_names(has_frames), "and"), "XYZ, PDB, mmCIF, LAMMPS, GROMACS, POSCAR, SDF and PQR");
    EXPECT_EQ(listed(format_endings(is_written), "or"), ".txt or .toml");
    EXPECT_EQ(listed(std::vector<std::string>{"a"}, "or"), "a");
    for (const SceneFormat& format : scene_formats()) {
        EXPECT_EQ(find_format(format.name), &format);
        for (const std::string_view ending : format.endings)
            EXPECT_EQ(format_of_name("a" + std::string(ending)).name, ending.empty() ? "text" : format.name);
    }
    EXPECT_EQ(find_format("xyz"), find_format("XYZ"));
    EXPECT_EQ(find_format("yaml"), nullptr);
}

// Desktops know CSV by a type that other programs share.
TEST(SceneFormats, OfDataHaveMimeTypes) {
    const std::string types(InputFile(test::source_file("packaging/sphereview.mime.xml")).bytes());
    for (const SceneFormat& format : scene_formats()) {
        if (!format.is_data || format.name == "CSV") continue;
        for (const std::string& ending : endings_of(format)) {
            EXPECT_NE(lower_case(types).find("<glob pattern=\"*" + ending + "\""), std::string::npos) << ending;
        }
    }
}

// A scene of many spheres has them in a block, one of few has a table for each.
TEST(SceneFormats, OfScenesHaveAMimeTypeByWhatTheyBeginWith) {
    const std::string types(InputFile(test::source_file("packaging/sphereview.mime.xml")).bytes());
    EXPECT_NE(types.find("value=\"[[sphere]]\""), std::string::npos);
    EXPECT_NE(write_scene(scene_of_alike(10), SceneFormat::toml).substr(0, 1024).find("[[sphere]]"), std::string::npos);
    EXPECT_NE(types.find("value=\"spheres = &quot;&quot;&quot;\""), std::string::npos);
    EXPECT_NE(write_scene(scene_of_alike(2000), SceneFormat::toml).substr(0, 1024).find("spheres = \"\"\""), std::string::npos);
}

TEST(LostIn, NamesWhatTheTextFormatCannotHold) {
    Scene scene = scene_of_alike(3);
    EXPECT_EQ(lost_in(scene, SceneFormat::text), "");
    scene.background = {{255, 255, 255}, false};
    scene.camera.eye.z = -1;
    scene.light.sky = 0.5;
    scene.names[1] = "sun";
    scene.names[2] = "moon";
    scene.spheres[0].hidden = true;
    EXPECT_EQ(lost_in(scene, SceneFormat::text), "the background, the camera, the light, the names (2), the hidden spheres (1)");
    EXPECT_EQ(lost_in(scene, SceneFormat::toml), "");
}

// What is written is read back the same, bit for bit. SPHEREVIEW_SEED=N tries other scenes.
TEST(RoundTrip, KeepsEveryBitOfRandomScenes) {
    constexpr int trials = 500;
    const std::uint64_t seed = test::number_from_environment("SPHEREVIEW_SEED", 20240607);
    int cameras = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::mt19937_64 random(seed + static_cast<std::uint64_t>(trial));  // a trial's own, to be tried again alone
        const Scene scene = random_scene(random);
        if (scene.camera != Camera{}) ++cameras;

        for (const SceneFormat& format : {SceneFormat::toml, SceneFormat::text}) {
            const std::string text = write_scene(scene, format);
            const Scene& expected = format == SceneFormat::toml ? scene : without_extras(scene);
            ASSERT_NO_THROW(ASSERT_EQ(difference(parse_scene(text, "s"), expected), ""))
                << "trial " << trial << " of SPHEREVIEW_SEED=" << seed << ":\n"
                << text;
        }
    }
    EXPECT_GT(cameras, trials / 20);  // else cameras were hardly tried
}

// The test above can only fail if this can.
TEST(RoundTrip, IsJudgedByEveryBit) {
    const auto changed = [](const auto& change) {
        Scene before = scene_of_alike(2);
        Scene after = before;
        change(after);
        return difference(after, before);
    };
    EXPECT_EQ(changed([](Scene&) {}), "");
    EXPECT_EQ(changed([](Scene& s) { s.spheres[1].center.x = -0.0; }), "sphere 1.center[0]: -0x0p+0 instead of 0x0p+0");
    EXPECT_EQ(changed([](Scene& s) { s.camera.up.z = 1; }), "camera.up[2]: 0x1p+0 instead of 0x0p+0");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].radius = 20.000000000000004; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].color.b = 0; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres[0].hidden = true; }), "");
    EXPECT_NE(changed([](Scene& s) { s.spheres.pop_back(); }), "");
    EXPECT_NE(changed([](Scene& s) { s.names[0] = "x"; }), "");
    EXPECT_NE(changed([](Scene& s) { s.background.transparent = true; }), "");
}

}  // namespace sphereview

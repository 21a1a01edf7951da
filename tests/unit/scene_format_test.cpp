#include "formats/scene_format.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

TEST(DetectFormat, BelievesTheContentBeforeTheName) {
    for (const char* content : {"0", "  \n 3 ",
                                "\xEF\xBB\xBF"
                                "1",
                                "+1", "-1", ".5", "1\n# not a comment here\na = 1"}) {
        EXPECT_EQ(detect_format(content, "s.toml"), SceneFormat::text) << content;
    }
    for (const char* content :
         {"# a comment", "\xEF\xBB\xBF\n# a comment", "# a comment\r\n\n #b\rspheres = '0'", "[camera]", "[[sphere]]",
          "background = 'white'", "camera.eye = [0, 0, 0]", "\"background\"=\"white\"", "\r\n  spheres = '0'", "1 = 2"}) {
        EXPECT_EQ(detect_format(content, "s.txt"), SceneFormat::toml) << content;
    }
}

TEST(DetectFormat, BelievesTheNameWhereTheContentIsUnclear) {
    for (const char* content : {"", " \n", "hello", "\x89PNG", "\xEF\xBB\xBF", "is 2 + 2 = 4?"}) {
        for (const char* name : {"s.toml", "S.TOML", "a.txt/s.Toml"}) {
            EXPECT_EQ(detect_format(content, name), SceneFormat::toml) << content;
        }
        for (const char* name : {"s.txt", "s", "toml", "s.toml.txt", "stdin"}) {
            EXPECT_EQ(detect_format(content, name), SceneFormat::text) << content;
        }
    }
}

TEST(DetectFormat, KnowsDataByItsName) {
    for (const auto& [name, format] : std::vector<std::pair<const char*, SceneFormat>>{{"a.xyz", SceneFormat::xyz},
                                                                                       {"b/a.ExtXYZ", SceneFormat::xyz},
                                                                                       {"a.csv", SceneFormat::csv},
                                                                                       {"a.pdb", SceneFormat::pdb},
                                                                                       {"pdb1crn.ent.gz", SceneFormat::pdb},
                                                                                       {"a.cif", SceneFormat::mmcif},
                                                                                       {"a.mmCIF.GZ", SceneFormat::mmcif},
                                                                                       {"a.csv.gz", SceneFormat::csv}}) {
        EXPECT_EQ(format_of_name(name), format) << name;
        for (const char* content : {"", "1 1 2 3 4 5 6 7", "[camera]", "# a comment"}) {
            EXPECT_EQ(detect_format(content, name), format) << name;
        }
    }
    EXPECT_EQ(format_of_name("a.toml.gz"), SceneFormat::toml);
    EXPECT_EQ(format_of_name("a.txt.gz"), SceneFormat::text);
    EXPECT_EQ(format_of_name("a.gz"), SceneFormat::text);
}

TEST(DetectFormat, KnowsDataOfAnotherNameByItsContent) {
    const std::vector<std::pair<std::string, SceneFormat>> cases = {
        {"3\nwater\nO 0 0 0\nH 0 0 1\nH 0 1 0\n", SceneFormat::xyz},
        {" 1 \r\n\r\n  Fe2+ 1 2 3\r\n", SceneFormat::xyz},
        {"1\r\rH 0 0 0", SceneFormat::xyz},
        {"1\nAtoms. Timestep: 0\n1 0 0 0\n", SceneFormat::xyz},
        {"1\n-76.4\nH 0 0\n", SceneFormat::xyz},
        {"1\nProperties=pos:R:3\n0 0 0\n", SceneFormat::xyz},
        {"x,y,z\n1,2,3\n", SceneFormat::csv},
        {"\xEF\xBB\xBF\n\"Name\";\"Z\";\"Y\";\"X\"\n", SceneFormat::csv},
        {"# x, y, z\n", SceneFormat::csv},
        {"HEADER    PLANT PROTEIN                           30-APR-81   1CRN\n", SceneFormat::pdb},
        {"ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79           N\n", SceneFormat::pdb},
        {"REMARK   1 R = 0.1\n", SceneFormat::pdb},
        {"data_1CRN\n#\nloop_\n", SceneFormat::mmcif},
        {"# written by a program\ndata_1CRN\n_entry.id = 1\n", SceneFormat::mmcif},
    };
    for (const auto& [content, format] : cases) {
        for (const char* name : {"stdin", "a.dat", "xyz"}) EXPECT_EQ(detect_format(content, name), format) << content;
    }
    // Neither data nor anything else where the name says what it is.
    EXPECT_EQ(detect_format("3\nwater\nO 0 0 0\n", "s.txt"), SceneFormat::text);
    EXPECT_EQ(detect_format("x,y,z\n", "s.toml"), SceneFormat::toml);
    // Scenes that look a little like data.
    for (const char* content :
         {"1\n255 0 0\n1 2 3 4\n", "2\n255 0 0\nhello 2 3 4\n", "1\n255 0 0 1 2 3 4\n", "1\n\n255 0 0 1 2 3 4\n",
          "1\n255 0 zero\n1 2 3 4\n", "1\nred\n0.5 2 3 4\n", "3\n", "2 3\na\nH 0 0 0\n", "-1\na\nH 0 0 0\n"}) {
        EXPECT_EQ(detect_format(content, "stdin"), SceneFormat::text) << content;
    }
    for (const char* content : {"x = 1", "data_x = 1", "TITLE = 'x'", "# x, y", "[x.y.z]"}) {
        EXPECT_EQ(detect_format(content, "stdin"), SceneFormat::toml) << content;
    }
}

TEST(FormatOfName, IsTomlForTomlOnly) {
    EXPECT_EQ(format_of_name("a/b.toml"), SceneFormat::toml);
    EXPECT_EQ(format_of_name("a/b.ToML"), SceneFormat::toml);
    EXPECT_EQ(format_of_name("a/b.txt"), SceneFormat::text);
    EXPECT_EQ(format_of_name("-"), SceneFormat::text);
}

TEST(ParseScene, ReadsEitherFormatWhateverTheName) {
    const Scene text = parse_scene("1 1 2 3 4 5 6 7", "s.toml");
    const Scene toml = parse_scene("[[sphere]]\ncolor = [1, 2, 3]\ncenter = [4, 5, 6]\nradius = 7\n", "s.txt");
    EXPECT_EQ(text, toml);
    ASSERT_EQ(text.spheres.size(), 1U);
    EXPECT_EQ(text.spheres[0], (Sphere{{4, 5, 6}, 7, {1, 2, 3}, false}));
}

TEST(DetectFormat, SaysThatTheTextFormatHasNoComments) {
    EXPECT_EQ(detect_format("# a comment\nhello", "s.toml"), SceneFormat::toml);
    for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
             {"# two\n2 1 2 3", "1:1"}, {"\xEF\xBB\xBF\n  # two\n # b\n2", "2:3"}, {"# hello\nhello", "1:1"}}) {
        EXPECT_EQ(message_of<InputError>([&] { detect_format(text, "s.txt"); }),
                  "s.txt:" + place +
                      ": found a comment, expected the number of spheres: only TOML has comments, the text format has none");
    }
}

TEST(ParseScene, NamesTheFileInBothFormats) {
    EXPECT_TRUE(message_of<InputError>([] { parse_scene("x", "a b.txt"); }).starts_with("a b.txt:1:1: found 'x'"));
    EXPECT_TRUE(message_of<InputError>([] { parse_scene("[x", "a b.txt"); }).starts_with("a b.txt:1:"));
}

TEST(LostIn, NamesWhatTheTextFormatCannotHold) {
    Scene scene;
    scene.spheres.resize(3);
    EXPECT_EQ(lost_in(scene, SceneFormat::text), "");
    scene.background = {{255, 255, 255}, false};
    scene.camera.eye.z = -1;
    scene.names[1] = "sun";
    scene.names[2] = "moon";
    scene.spheres[0].hidden = true;
    EXPECT_EQ(lost_in(scene, SceneFormat::text), "the background, the camera, the names (2), the hidden spheres (1)");
    EXPECT_EQ(lost_in(scene, SceneFormat::toml), "");
}

}  // namespace sphereview

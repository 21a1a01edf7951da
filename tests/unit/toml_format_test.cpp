#include "formats/toml_format.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

namespace sphereview {

TEST(TomlFormat, ReadsEveryKey) {
    const Scene scene = parse_toml(R"(
# Sun and moon.
background = "#102030"

[camera]
eye = [1, 2.5, -3e2]
center = [1, 2.5, 100.0]
right = [7, 0, 0]
up = [0, 7.0, 0]

[[sphere]]
name = "Sun \"☉\""
color = [255, 200, 0]
center = [0, -0.0, 200]
radius = 20
hidden = true

[[sphere]]
radius = +1.5
center = [1e3, 2, 3]
color = [0, 0x10, 255]
hidden = false
)",
                                   "s.toml");
    Scene expected;
    expected.background = {{16, 32, 48}, false};
    expected.camera = {{1, 2.5, -300}, {1, 2.5, 100}, {7, 0, 0}, {0, 7, 0}};
    expected.spheres = {{{0, 0, 200}, 20, {255, 200, 0}, true}, {{1000, 2, 3}, 1.5, {0, 16, 255}, false}};
    expected.names = {{0, "Sun \"\u2609\""}};
    EXPECT_EQ(scene, expected);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(scene.spheres[0].center.y), std::bit_cast<std::uint64_t>(-0.0));
}

TEST(TomlFormat, HasADefaultForEverything) {
    for (const char* text : {"# nothing\n", "[camera]\n", "sphere = []\n", "spheres = '0'\n", "background = 'black'"}) {
        EXPECT_EQ(parse_toml(text, "s.toml"), Scene{}) << text;
    }
    Scene moved;
    moved.camera.eye = {0, 0, -5};
    EXPECT_EQ(parse_toml("camera.eye = [0, 0, -5]", "s.toml"), moved);
}

TEST(TomlFormat, TakesLineEndsAndAByteOrderMark) {
    Scene expected;
    expected.spheres = {{{4, 5, 6}, 7, {1, 2, 3}, false}};
    for (const std::string text :
         {"spheres = \"\"\"\n1\n1 2 3\n4 5 6\n7\n\"\"\"\n", "spheres = \"\"\"\r\n1\r\n1 2 3\r\n4 5 6\r\n7\r\n\"\"\"\r\n",
          "\xEF\xBB\xBFspheres = '''1 1 2 3 4 5 6 7'''", "spheres = '1 1 2 3 4 5 6 7'", "spheres = \"1\\n1 2 3\\t4 5 6 7\"",
          "sphere = [{ color = [1, 2, 3], center = [4, 5, 6], radius = 7 }]"}) {
        EXPECT_EQ(parse_toml(text, "s.toml"), expected) << text;
    }
}

TEST(TomlFormat, ReadsBackgrounds) {
    EXPECT_EQ(parse_toml("background = 'white'", "s").background, (Background{{255, 255, 255}, false}));
    EXPECT_EQ(parse_toml("background = 'transparent'", "s").background, (Background{{0, 0, 0}, true}));
    EXPECT_EQ(parse_toml("background = '#FF8000'", "s").background, (Background{{255, 128, 0}, false}));
}

TEST(TomlFormat, IsWrittenWithoutDefaults) {
    EXPECT_EQ(write_toml({}), "# An empty scene.\n");
    Scene scene;
    scene.spheres = {{{0, -0.0, 1e300}, 20, {1, 2, 3}, false}, {{0.5, 1, 2}, 5e-324, {0, 0, 0}, true}};
    scene.names[1] = "a\"b\\c\n\x7F";
    EXPECT_EQ(write_toml(scene),
              "[[sphere]]\ncolor = [1, 2, 3]\ncenter = [0.0, -0.0, 1e+300]\nradius = 20.0\n"
              "\n[[sphere]]\nname = \"a\\\"b\\\\c\\u000a\\u007f\"\ncolor = [0, 0, 0]\ncenter = [0.5, 1.0, 2.0]\nradius = 5e-324\n"
              "hidden = true\n");
    scene.spheres.clear();
    scene.names.clear();
    scene.background = {{255, 255, 255}, false};
    scene.camera.eye = {0, 0, -1};
    EXPECT_EQ(write_toml(scene),
              "background = \"white\"\n\n[camera]\neye = [0.0, 0.0, -1.0]\ncenter = [0.0, 0.0, 100.0]\n"
              "right = [50.0, 0.0, 0.0]\nup = [0.0, 50.0, 0.0]\n");
}

TEST(TomlFormat, HoldsManyPlainSpheresAsText) {
    Scene scene;
    scene.spheres.resize(most_sphere_tables + 1);
    EXPECT_TRUE(write_toml(scene).starts_with("spheres = \"\"\"\n1001\n"));
    EXPECT_EQ(parse_toml(write_toml(scene), "s.toml"), scene);
    scene.spheres.pop_back();
    EXPECT_TRUE(write_toml(scene).starts_with("[[sphere]]\n"));
}

TEST(TomlFormat, HoldsManySpheresAsTextWithWhatIsSaidOfSingleOnes) {
    Scene named;
    named.spheres.resize(most_sphere_tables + 1);
    named.names[7] = "seven";
    Scene hidden;
    hidden.spheres.resize(most_sphere_tables + 1);
    for (std::size_t i = 0; i < 40; ++i) hidden.spheres[25 * i].hidden = true;
    hidden.camera.eye.z = -1;
    hidden.names = {{0, "a\"b"}, {1000, "last"}};
    for (const Scene& scene : {named, hidden}) {
        EXPECT_TRUE(write_toml(scene).starts_with("spheres = \"\"\"\n1001\n"));
        EXPECT_EQ(write_toml(scene).find("[[sphere]]"), std::string::npos);
        EXPECT_EQ(parse_toml(write_toml(scene), "s.toml"), scene);
    }
}

}  // namespace sphereview

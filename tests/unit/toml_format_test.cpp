// Scenes in the native format.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "base/error.hpp"
#include "formats/sphere_data.hpp"
#include "support/spheres.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

Scene toml_scene(const std::string& text) { return read_toml(text, "s.toml", {}).scene; }

}  // namespace

TEST(TomlFormat, ReadsEveryKey) {
    const Scene scene = toml_scene(R"(
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
)");
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
        EXPECT_EQ(toml_scene(text), Scene{}) << text;
    }
    Scene moved;
    moved.camera.eye = {0, 0, -5};
    EXPECT_EQ(toml_scene("camera.eye = [0, 0, -5]"), moved);
    EXPECT_EQ(toml_scene("[camera]\neye = [0, 0, -5]\nprojection = 'perspective'"), moved);
    moved.camera.projection = Projection::orthographic;
    EXPECT_EQ(toml_scene("[camera]\neye = [0, 0, -5]\nprojection = 'orthographic'"), moved);
    EXPECT_EQ(toml_scene(write_toml(moved)), moved);
}

TEST(TomlFormat, TakesLineEndsAndAByteOrderMark) {
    Scene expected = scene_of({{{4, 5, 6}, 7, {1, 2, 3}, false}});
    for (const std::string text :
         {"spheres = \"\"\"\n1\n1 2 3\n4 5 6\n7\n\"\"\"\n", "spheres = \"\"\"\r\n1\r\n1 2 3\r\n4 5 6\r\n7\r\n\"\"\"\r\n",
          "\xEF\xBB\xBFspheres = '''1 1 2 3 4 5 6 7'''", "spheres = '1 1 2 3 4 5 6 7'", "spheres = \"1\\n1 2 3\\t4 5 6 7\"",
          "sphere = [{ color = [1, 2, 3], center = [4, 5, 6], radius = 7 }]"}) {
        EXPECT_EQ(toml_scene(text), expected) << text;
    }
}

// Read in pieces; quotes of strings of several lines, also in a comment, have the whole tree made.
TEST(TomlFormat, HoldsManyTables) {
    std::string text = "background = 'white'\n[camera]\neye = [1, 0, 0]\ncenter = [1, 0, 100]\n";
    for (int i = 0; i < 12'000; ++i) {
        text += i % 7 == 0 ? "  [[sphere]] # one\r\n" : "[[sphere]]\n";
        if (i % 3 == 0) text += "name = \"number " + std::to_string(i) + "\"\n";
        text += "color = [" + std::to_string(i % 256) + ", 2, 3]\ncenter = [\n  " + std::to_string(i) +
                ",\n  4, 5\n]\n# [[sphere]]\nradius = 7\nhidden = " + (i == 11'999 ? "true" : "false") + "\n";
        if (i == 5000) text += "[[view]]\nname = \"a\"\n";
    }
    text += "[[view]]\nname = \"[[sphere]]\"\n";
    ASSERT_GT(text.size(), std::size_t{1} << 20);
    const Scene scene = toml_scene(text);
    ASSERT_EQ(scene.spheres.size(), 12'000U);
    EXPECT_EQ(scene.spheres[11'999], (Sphere{{11'999, 4, 5}, 7, {223, 2, 3}, true}));
    EXPECT_EQ(scene.names.size(), 4'000U);
    EXPECT_EQ(scene.names.at(9'999), "number 9999");
    EXPECT_EQ(scene.views.size(), 2U);
    EXPECT_EQ(scene.camera.eye.x, 1.0);
    EXPECT_EQ(toml_scene("# \"\"\"\n" + text), scene);

    // A fault is where the whole tree has it.
    const auto fault = [](const std::string& wrong) { return message_of<InputError>([&] { toml_scene(wrong); }); };
    const std::string last = "[[sphere]]\ncolor = [1, 2, 3]\ncenter = [4, 5, 6]\n";
    const std::string line = std::to_string(std::count(text.begin(), text.end(), '\n') + 1);
    EXPECT_EQ(fault(text + last), "s.toml:" + line + ":1: [[sphere]] 12001 has no 'radius', which it needs");
    for (const std::string& wrong : {text + last + "radius = 7\n[sphere.x]\n", text + "[[ sphere ]]\n", text + "[names]\n1 = 'a'\n",
                                     "sphere = 1\n" + text, text + "[camera]\n", text + "x = [\n[[sphere]]\n]\n"}) {
        const std::string said = fault(wrong);
        const std::size_t begin = std::string("s.toml:").size();
        ASSERT_GT(said.size(), begin);
        EXPECT_EQ(fault("# '''\n" + wrong),
                  "s.toml:" + std::to_string(std::stoi(said.substr(begin)) + 1) + said.substr(said.find(':', begin)));
    }
}

TEST(TomlFormat, IsWrittenWithoutDefaults) {
    EXPECT_EQ(write_toml({}), "# An empty scene.\n");
    Scene scene = scene_of({{{0, -0.0, 1e300}, 20, {1, 2, 3}, false}, {{0.5, 1, 2}, 5e-324, {0, 0, 0}, true}});
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

TEST(TomlFormat, HoldsSavedViews) {
    const std::string text =
        "[[view]]\nname = \"from above\"\neye = [0.0, 0.0, -9.0]\ncenter = [0.0, 0.0, 100.0]\n"
        "right = [50.0, 0.0, 0.0]\nup = [0.0, 50.0, 0.0]\nprojection = \"orthographic\"\n"
        "\n[[view]]\nname = \"b\\\"c\"\neye = [0.0, 0.0, 0.0]\ncenter = [0.0, 0.0, 100.0]\n"
        "right = [50.0, 0.0, 0.0]\nup = [0.0, 50.0, 0.0]\n";
    Scene scene;
    scene.views = {{"from above", {.eye = {0, 0, -9}, .projection = Projection::orthographic}}, {"b\"c", {}}};
    EXPECT_EQ(write_toml(scene), text);
    EXPECT_EQ(toml_scene(text), scene);
    EXPECT_EQ(toml_scene("view = [{name = 'b\"c'}]").views, std::vector{scene.views[1]});
    scene.spheres.resize(most_sphere_tables + 1);
    scene.names[3] = "three";
    EXPECT_EQ(toml_scene(write_toml(scene)), scene);
    EXPECT_EQ(toml_scene("view = []"), Scene{});
}

TEST(TomlFormat, HoldsManyPlainSpheresAsText) {
    Scene scene = scene_of_alike(most_sphere_tables + 1);
    EXPECT_TRUE(write_toml(scene).starts_with("spheres = \"\"\"\n1001\n"));
    EXPECT_EQ(toml_scene(write_toml(scene)), scene);
    scene.spheres.pop_back();
    EXPECT_TRUE(write_toml(scene).starts_with("[[sphere]]\n"));
}

TEST(TomlFormat, HoldsManySpheresAsTextWithWhatIsSaidOfSingleOnes) {
    Scene named = scene_of_alike(most_sphere_tables + 1);
    named.names[7] = "seven";
    Scene hidden = scene_of_alike(most_sphere_tables + 1);
    for (std::size_t i = 0; i < 40; ++i) hidden.spheres[25 * i].hidden = true;
    hidden.camera.eye.z = -1;
    hidden.names = {{0, "a\"b"}, {1000, "last"}};
    for (const Scene& scene : {named, hidden}) {
        EXPECT_TRUE(write_toml(scene).starts_with("spheres = \"\"\"\n1001\n"));
        EXPECT_EQ(write_toml(scene).find("[[sphere]]"), std::string::npos);
        EXPECT_EQ(toml_scene(write_toml(scene)), scene);
    }
}

// As --sun and its like do: shadows have room in a sky that comes with a sun, unless somebody says how strong it is.

TEST(TomlFormat, MakesRoomForASunOfWhichNothingMoreIsSaid) {
    struct Case {
        const char* more;
        double sky;
        double sun;
    };
    for (const auto& [more, sky, sun] : {Case{"", 0.4, 0.7},
                                         {"key = 0.5\nlights = 32", 0.4, 0.7},
                                         {"sun_strength = 2", 0.4, 2.0},
                                         {"sky = 1", 1.0, 1.0},
                                         {"sky = 0.25", 0.25, 1.0},
                                         {"sky = 1\nsun_strength = 0.7", 1.0, 0.7}}) {
        const Light light = toml_scene(std::string("[light]\nsun = [0, 1, 0]\n") + more).light;
        EXPECT_EQ(sky_of(light), sky) << more;
        EXPECT_EQ(sun_strength_of(light), sun) << more;
    }
    EXPECT_EQ(sky_of(Light{}), 1.0);
}

TEST(TomlFormat, KeepsTheLight) {
    for (const Light& light :
         {Light{}, Light{.lights = 64}, Light{.lights = {}, .sky = 0.25}, Light{.sky = most_sky}, Light{.key = 0.5},
          Light{.lights = {}, .sky = 0.0, .sun = Sun{}}, Light{.sun = Sun{}}, Light{.sun = Sun{{0.0, 1.0, 0.0}, sun_beside_sky}},
          Light{.sky = sky_beside_sun, .sun = Sun{}}, Light{.sky = sky_beside_sun, .sun = Sun{{0.0, 1.0, 0.0}, sun_beside_sky}},
          Light{.lights = 1024, .sky = 1.0, .sun = Sun{{0.1, -1e-300, 1e300}, 3.75}}}) {
        Scene scene;
        scene.light = light;
        scene.camera.eye.x = 3.0;
        EXPECT_EQ(toml_scene(write_toml(scene)), scene) << write_toml(scene);
    }
}

}  // namespace sphereview

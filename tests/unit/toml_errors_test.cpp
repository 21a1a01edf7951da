// What is said of a file that is no scene in the native format.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "formats/sphere_data.hpp"
#include "unit/message_of.hpp"

namespace sphereview {

namespace {

std::string message(const std::string& text) {
    return message_of<InputError>([&] { read_toml(text, "s.toml", {}); });
}

void expect_toml_messages(const std::vector<WrongText>& cases) {
    expect_messages(
        "s.toml", [](const std::string& text) { read_toml(text, "s.toml", {}); }, cases);
}

// A sphere whose keys are right, for `key`'s line to be replaced by `line` (the file's second to fourth).
std::string sphere_with(const std::string& key, const std::string& line) {
    std::string text = "[[sphere]]\n";
    for (const std::string good : {"color = [1, 2, 3]", "center = [4, 5, 6]", "radius = 7"}) {
        text += (good.starts_with(key + " ") ? line : good) + "\n";
    }
    return text;
}

}  // namespace

TEST(TomlErrors, SuggestTheKeyThatWasMeant) {
    expect_toml_messages({
        {"backgroud = 'white'",
         "1:1: found the unknown key 'backgroud' in the scene, expected one of background, camera, light, view, property, sphere, "
         "spheres, "
         "hidden, names; did you mean 'background'?"},
        {"[camera]\n  Eye = [0, 0, 0]",
         "2:3: found the unknown key 'Eye' in [camera], expected one of eye, center, right, up, projection; did you mean 'eye'?"},
        {"[[sphere]]\ncolour = [1, 2, 3]",
         "2:1: found the unknown key 'colour' in [[sphere]] 1, expected one of name, color, center, radius, hidden; did you mean "
         "'color'?"},
        {"[lights]\n",
         "1:2: found the unknown key 'lights' in the scene, expected one of background, camera, light, view, property, sphere, "
         "spheres, "
         "hidden, "
         "names; did you mean 'light'?"},
        {"[light]\nsunn = 1",
         "2:1: found the unknown key 'sunn' in [light], expected one of lights, sky, key, sun, sun_strength; did you mean 'sun'?"},
    });
}

TEST(TomlErrors, SayWhatIsWrongWithTheLight) {
    expect_toml_messages({
        {"light = 1", "1:9: found 1, expected the table [light]"},
        {"[light]\nlights = 15", "2:10: found 15, expected 'lights' as a whole number from 16 to 1024"},
        {"[light]\nlights = 1025", "2:10: found 1025, expected 'lights' as a whole number from 16 to 1024"},
        {"[light]\nlights = 64.0", "2:10: found 64.0, expected 'lights' as a whole number from 16 to 1024"},
        {"[light]\nsky = -0.1", "2:7: found -0.10000000000000001, expected 'sky' as a number from 0 to 1"},
        {"[light]\nsky = nan", "2:7: found nan, expected 'sky' as a number from 0 to 1"},
        {"[light]\nkey = 1.5", "2:7: found 1.5, expected 'key' as a number from 0 to 1"},
        {"[light]\nsun = [0, 0, -0.0]", "2:7: found a sun in no direction, expected 'sun' other than [0, 0, 0]"},
        {"[light]\nsun = [0, 1]", "2:7: found 2 values, expected 'sun' as three finite numbers [x, y, z]"},
        {"[light]\nsun = [0, 1, 0]\nsun_strength = 0", "3:16: found 0, expected 'sun_strength' as a number from 0.001 to 4"},
        {"[light]\nsun_strength = 1", "2:16: found 'sun_strength' without 'sun', expected 'sun = [x, y, z]' as well"},
    });
}

TEST(TomlErrors, NameWhatIsMissingOrThereTwice) {
    const std::string empty = "1:1: the file is empty, expected a scene in TOML";
    expect_toml_messages({
        {"", empty},
        {" \r\n", empty},
        {"\xEF\xBB\xBF\n", empty},
        {"spheres = '0'\n[[sphere]]\n", "1:11: found both 'spheres' and [[sphere]], expected only one of them"},
        {sphere_with("color", ""), "1:1: [[sphere]] 1 has no 'color', which it needs"},
        {sphere_with("center", ""), "1:1: [[sphere]] 1 has no 'center', which it needs"},
        {sphere_with("", "") + "\n" + sphere_with("radius", ""), "6:1: [[sphere]] 2 has no 'radius', which it needs"},
    });
}

TEST(TomlErrors, SayWhichTypeWasExpected) {
    const std::string color = "'color' as three whole numbers [R, G, B] from 0 to 255";
    const std::string center = "'center' as three finite numbers [x, y, z]";
    expect_toml_messages({
        {sphere_with("color", "color = 'red'"), "2:9: found 'red', expected " + color},
        {sphere_with("color", "color = [1, 2]"), "2:9: found 2 values, expected " + color},
        {sphere_with("color", "color = [1, 256, 3]"), "2:13: found 256, expected " + color},
        {sphere_with("color", "color = [1, 2, -1]"), "2:16: found -1, expected " + color},
        {sphere_with("color", "color = [1.5, 2, 3]"), "2:10: found 1.5, expected " + color},
        {sphere_with("center", "center = 4"), "3:10: found 4, expected " + center},
        {sphere_with("center", "center = [1, 2, 3, 4]"), "3:10: found 4 values, expected " + center},
        {sphere_with("center", "center = [1, '2', 3]"), "3:14: found '2', expected " + center},
        {sphere_with("center", "center = [1, 2, nan]"), "3:17: found nan, expected " + center},
        {sphere_with("center", "center = [-inf, 2, 3]"), "3:11: found -inf, expected " + center},
        {sphere_with("radius", "radius = [7]"),
         "4:10: found a value of type 'array', expected 'radius' as a finite number above 0"},
        {sphere_with("radius", "radius = '3'"), "4:10: found '3', expected 'radius' as a finite number above 0"},
        {sphere_with("radius", "radius = inf"), "4:10: found inf, expected 'radius' as a finite number above 0"},
        {sphere_with("radius", "radius = 0"), "4:10: found 0, expected 'radius' above 0"},
        {sphere_with("radius", "radius = -1.5"), "4:10: found -1.5, expected 'radius' above 0"},
        {sphere_with("radius", "radius = 7\nhidden = 1"), "5:10: found 1, expected 'hidden' as true or false"},
        {sphere_with("radius", "radius = 7\nname = 1"), "5:8: found 1, expected 'name' as a string"},
        {"camera = 1", "1:10: found 1, expected the table [camera]"},
        {"view = 1", "1:8: found 1, expected 'view' as tables, each headed [[view]]"},
        {"[view]\nname = 'a'", "1:1: found a value of type 'table', expected 'view' as tables, each headed [[view]]"},
        {"view = [1]", "1:9: found 1, expected 'view' as tables, each headed [[view]]"},
        {"[[view]]\neye = [0, 0, 1]", "1:1: [[view]] 1 has no 'name', which it needs"},
        {"[[view]]\nname = 1", "2:8: found 1, expected 'name' as a string"},
        {"[[view]]\nname = ' '", "2:8: found ' ', no name, expected a name of its own for the view"},
        {"[[view]]\nname = 'top'", "2:8: found 'top', the name of a side, expected a name of its own for the view"},
        {"[[view]]\nname = '30,-20.5'",
         "2:8: found '30,-20.5', an azimuth and an elevation, expected a name of its own for the view"},
        {"[[view]]\nname = 'a'\n[[view]]\nname = 'a'", "4:8: found 'a' again, expected each name once"},
        {"[[view]]\nname = 'a'\nEye = [0, 0, 1]",
         "3:1: found the unknown key 'Eye' in [[view]] 1, expected one of name, eye, center, right, up, projection; did you mean "
         "'eye'?"},
        {"[[view]]\nname = 'a'\nup = [0, 1, 0]",
         "3:6: found a camera that cannot be used: 'right' and 'up' are not equally long; expected perpendicular, equally long "
         "'right' and 'up' (within 1e-6) and an eye off the screen's plane"},
        {"sphere = 1", "1:10: found 1, expected 'sphere' as tables, each headed [[sphere]]"},
        {"sphere = [1]", "1:11: found 1, expected 'sphere' as tables, each headed [[sphere]]"},
        {"sphere = [{color = [1, 2, 3], center = [4, 5, 6], radius = 7}, true]",
         "1:64: found a value of type 'boolean', expected 'sphere' as tables, each headed [[sphere]]"},
        {"[sphere]\nradius = 1", "1:1: found a value of type 'table', expected 'sphere' as tables, each headed [[sphere]]"},
        {"spheres = 1", "1:11: found 1, expected 'spheres' as a string in the text format"},
        {"background = 0", "1:14: found 0, expected 'background' as a string: black, white, transparent or #rrggbb"},
        {"background = 'grey'", "1:14: found 'grey', expected 'background' as a string: black, white, transparent or #rrggbb"},
        {"[camera]\nprojection = 'parallel'",
         "2:14: found 'parallel', expected 'projection' as \"perspective\" or \"orthographic\""},
        {"[camera]\neye = [0, 0, inf]", "2:14: found inf, expected 'eye' as three finite numbers [x, y, z]"},
    });
}

TEST(TomlErrors, SayWhyACameraCannotBeUsed) {
    const std::string in_plane = "'eye' lies in the screen's plane, or within 1e-6 of its distance from 'center'";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"up = [1, 50, 0]", "3:6: 'up' is not perpendicular to 'right'"},
        {"right = [50, 0, 0]\nup = [0, 51, 0]", "4:6: 'right' and 'up' are not equally long"},
        {"center = [0, 0, 9]\neye = [1, 2, 9]", "4:7: " + in_plane},
        {"eye = [0, 0, 100]", "3:7: 'eye' and 'center' are the same point"},
        {"right = [0, 0, 0]", "3:9: 'right' is zero"},
    };
    for (const auto& [line, fault] : cases) {
        EXPECT_EQ(message("# a comment\n[camera]\n" + line + "\n"),
                  "s.toml:" + fault.substr(0, fault.find(' ')) +
                      " found a camera that cannot be used:" + fault.substr(fault.find(' ')) +
                      "; expected perpendicular, equally long 'right' and 'up' (within 1e-6) and an eye off the screen's plane");
    }
}

TEST(TomlErrors, StandWhereTheyAreInsideTheSpheresText) {
    const std::string red = "found 'x', expected the red of sphere 1 of 1, a whole number";
    expect_toml_messages({
        {"# one\nspheres = \"\"\"\n1\n  x 2 3\n\"\"\"", "4:3: " + red},
        {"# one\r\nspheres = \"\"\"\r\n1\r\n  x 2 3\r\n\"\"\"", "4:3: " + red},
        {"spheres = '''1\n x'''", "2:2: " + red},
        {"spheres = '''1 x'''", "1:16: " + red},
        {"  spheres  =  \"1 x\"", "1:18: " + red},
        {"\xEF\xBB\xBFspheres = '''1 x'''", "1:16: " + red},
        {"# \xC3\xA9\nspheres = '1 x'", "2:14: " + red},
        {"\nspheres = \"1\\n x\"", "2:11: in the value's text:2:2: " + red},
        {"spheres = \"\"\"\n1\n\\u0020x \\\" \"\"\"", "1:11: in the value's text:2:2: " + red},
        {"spheres = '1 x\\n'", "1:14: found 'x\\n', expected the red of sphere 1 of 1, a whole number"},
        {"spheres = ''", "1:12: the text is empty, expected the number of spheres"},
        {"spheres = '1'", "1:13: the text ends, expected the red of sphere 1 of 1"},
    });
}

TEST(TomlErrors, SayWhatIsWrongWithWhatIsSaidOfSingleSpheres) {
    const std::string two = "spheres = '2 1 2 3 4 5 6 7 1 2 3 4 5 6 7'\n";
    const std::string number = ", expected the number of one of 2 spheres, from 0";
    expect_toml_messages({
        {two + "[names]\n2 = 'x'", "3:1: found '2'" + number},
        {two + "[names]\n01 = 'x'", "3:1: found '01'" + number},
        {two + "[names]\nsun = 'x'", "3:1: found 'sun'" + number},
        {two + "[names]\n1 = 7", "3:5: found 7, expected a name as a string"},
        {two + "names = 1", "2:9: found 1, expected the table [names]"},
        {two + "hidden = [0, 2]", "2:14: found '2'" + number},
        {two + "hidden = [-1]", "2:11: found '-1'" + number},
        {two + "hidden = [1,\n 1]", "3:2: found 1 again, expected each number once"},
        {two + "hidden = ['1']", "2:11: found '1', expected the number of a sphere"},
        {two + "hidden = true", "2:10: found a value of type 'boolean', expected 'hidden' as an array of the numbers of spheres"},
        {"hidden = [0]", "1:10: found 'hidden' without 'spheres', expected 'spheres', or 'hidden' in each [[sphere]]"},
        {"[names]\n0 = 'x'", "1:1: found 'names' without 'spheres', expected 'spheres', or 'name' in each [[sphere]]"},
    });
    EXPECT_TRUE(message(two + "[names]\n1 = 'x'\n1 = 'y'").starts_with("s.toml:4:"));
}

TEST(TomlErrors, SayWhereTheFileIsNotToml) {
    for (const auto& [text, place] : std::vector<std::pair<std::string, std::string>>{
             {"background = \n", "1:14"},
             {"[camera]\neye = [0, 0", "2:12"},
             {"background = 'white'\nbackground = 'black'", "2:14"},
             {"[camera\n", "1:8"},
             {std::string("a\0b = 1", 7), "1:2"},
             {"a = '\xFF'", "1:5"},
             {"a = 99999999999999999999", "1:5"},
             {"a = [1, 0xfffffffffffffffff, 3]", "1:9"},
             {"a = 1\nb = 1e400 # large\n", "2:5"},
             {"\"\xC3\xA9\"=-99_999_999_999_999_999_999", "1:5"},
         }) {
        EXPECT_TRUE(message(text).starts_with("s.toml:" + place + ": this is not TOML: ")) << message(text);
    }
}

TEST(TomlErrors, AreOnePrintableLine) {
    for (const std::string text : {"a = \x1b[2J", "\x1b", "\xC3\xA9\xC3\xA9 = 1", "a = \"\\q\n\"", "a\r= 1"}) {
        for (const char c : message(text)) EXPECT_TRUE(c >= ' ' && c <= '~') << message(text);
    }
}

TEST(TomlErrors, RefuseDeepNestingWithoutExhaustingTheStack) {
    std::string key = "\n[a";
    for (int i = 0; i < 40'000; ++i) key += ".a";
    EXPECT_EQ(message("a = " + std::string(100'000, '[')),
              "s.toml:1:37: found values nested more than 32 deep, expected at most 32");
    EXPECT_EQ(message(key), "s.toml:2:65: found a key of more than 32 parts, expected at most 32");
}

TEST(TomlErrors, OfAnUnknownKeyComeBeforeALargeTree) {
    std::string large = "# not even whole\n a = [";
    for (int i = 0; i < 400'000; ++i) large += "{},";
    EXPECT_TRUE(message(large).starts_with("s.toml:2:2: found the unknown key 'a' in the scene")) << message(large);
}

TEST(NumberLiterals, KeepsThePlacesOfMistakesAroundIt) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"spheres = \"\"\"\n1\n1 2 3 4 5 6 0\n\"\"\"\n", "3:13: found '0', expected the radius of sphere 1 of 1 above 0"},
        {"spheres = \"\"\"\n0\n1\"\"\"\n", "3:1: found '1', expected the end of the text after 0 spheres"},
        {"spheres = \"\"\"\r\n\r\n\r\n0\"\"\"\r\ncolour = 1\r\n", "5:1: found the unknown key 'colour'"},
        {"spheres = \"\"\"\n0\n\"\"\"\nspheres = \"\"\"0\"\"\"\n", "4:11: this is not TOML"},
        {"spheres = \"\"\"\n0\n  0 \"\"\" x\n", "3:9: this is not TOML"},
    };
    for (const auto& [content, place] : cases) {
        EXPECT_TRUE(message(content).starts_with("s.toml:" + place)) << message(content);
    }
}

}  // namespace sphereview

// What a person is told of a scene that is no scene, and where.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

struct BadScene {
    std::string content;
    std::string place;  // LINE:COLUMN
    std::string found;
    std::string expected;
};

// Renders the content as NAME and expects one line "NAME:LINE:COLUMN: ...", status 2 and no picture.
void expect_refused(const std::string& name, const BadScene& bad) {
    SCOPED_TRACE(testing::PrintToString(bad.content.substr(0, 80)));
    const TemporaryFolder folder;
    folder.write(name, bad.content);
    const Outcome outcome = render(folder, {name, "-s", "5x5"});
    EXPECT_TRUE(fails(outcome, 2, name + ":" + bad.place + ": "));
    EXPECT_TRUE(contains(outcome.errors, bad.found));
    EXPECT_TRUE(contains(outcome.errors, bad.expected));
    EXPECT_EQ(folder.names(), std::vector<std::string>{name});
}

TEST(BadScene, TextIsRefusedWithItsPlaceWhatWasFoundAndExpected) {
    const std::string head = "1\n1 2 3\n0 0 9\n";
    const std::string binary("1\0\x01\x02", 4);
    const std::vector<BadScene> cases = {
        {"", "1:1", "empty", "expected the number of spheres"},
        {" \n\t\n", "3:1", "empty", "expected the number of spheres"},
        {"hello\n", "1:1", "found 'hello'", "expected the number of spheres, a whole number"},
        {binary, "1:1", "found '1\\x00\\x01\\x02'", "expected the number of spheres"},
        {"\x7f"
         "ELF",
         "1:1", "found '\\x7fELF'", "expected the number of spheres"},
        {"\n# two\n2\n", "2:1", "found '#'", "expected the number of spheres: only TOML has comments"},
        {"-1\n", "1:1", "found '-1'", "expected the number of spheres from 0 to"},
        {"2.5\n", "1:1", "found '2.5'", "expected the number of spheres, a whole number"},
        {"2000000001\n", "1:1", "found '2000000001'", "from 0 to 2000000000"},
        {"99999999999999999999\n", "1:1", "found '99999999999999999999'", "from 0 to 2000000000"},
        {"2000000000\n", "2:1", "the text ends", "expected the red of sphere 1 of 2000000000"},
        {"1\n", "2:1", "the text ends", "expected the red of sphere 1 of 1"},
        {head, "4:1", "the text ends", "expected the radius of sphere 1 of 1"},
        {"1\n1 2 3\n0 0", "3:4", "the text ends", "expected the centre's z of sphere 1 of 1"},
        {"2\n1 2 3\n0 0 9\n1\n", "5:1", "the text ends", "expected the red of sphere 2 of 2"},
        {head + "1\n  7\n", "5:3", "found '7'", "expected the end of the text after 1 sphere"},
        {"0\n1 2 3\n", "2:1", "found '1'", "expected the end of the text after 0 spheres"},
        {"1\n256 2 3\n0 0 9\n1\n", "2:1", "found '256'", "expected the red of sphere 1 of 1 from 0 to 255"},
        {"1\n1 -1 3\n0 0 9\n1\n", "2:3", "found '-1'", "expected the green of sphere 1 of 1 from 0 to 255"},
        {"1\n1 2 3.0\n0 0 9\n1\n", "2:5", "found '3.0'", "expected the blue of sphere 1 of 1, a whole number"},
        {"1\n1 2 red\n0 0 9\n1\n", "2:5", "found 'red'", "expected the blue of sphere 1 of 1, a whole number"},
        {"1\n1 2 3\nx 0 9\n1\n", "3:1", "found 'x'", "expected the centre's x of sphere 1 of 1, a number"},
        {"1\n1 2 3\n0 1,5 9\n1\n", "3:3", "found '1,5'", "expected the centre's y of sphere 1 of 1, a number"},
        {"1\n1 2 3\n0 nan 9\n1\n", "3:3", "found 'nan'", "a finite number"},
        {"1\n1 2 3\n0 0 -inf\n1\n", "3:5", "found '-inf'", "a finite number"},
        {"1\n1 2 3\n0 0 1e999\n1\n", "3:5", "found '1e999'", "a number that a double can hold"},
        {head + "0\n", "4:1", "found '0'", "expected the radius of sphere 1 of 1 above 0"},
        {head + "-3\n", "4:1", "found '-3'", "expected the radius of sphere 1 of 1 above 0"},
        {head + "NaN\n", "4:1", "found 'NaN'", "a finite number"},
        {head + "inf\n", "4:1", "found 'inf'", "a finite number"},
        {"1\r\n1 2 3\r\n0 0 9\r\nx\r\n", "4:1", "found 'x'", "expected the radius"},
        {"\xEF\xBB\xBFx", "1:1", "found 'x'", "expected the number of spheres"},
    };
    for (const BadScene& bad : cases) expect_refused("scene.txt", bad);
}

TEST(BadScene, TomlIsRefusedWithItsPlaceWhatWasFoundAndExpected) {
    const auto sphere = [](const std::string& line) { return "[[sphere]]\n" + line + "\n"; };
    const std::string rest = "\ncolor = [1, 2, 3]\ncenter = [0, 0, 9]";
    const std::vector<BadScene> cases = {
        {"", "1:1", "empty", "expected a scene in TOML"},
        {"hello", "1:6", "not TOML", ""},
        {"background = \"red\"", "1:14", "found 'red'", "expected 'background' as a string: black, white, transparent or #rrggbb"},
        {"background = 3", "1:14", "found 3", "expected 'background'"},
        {"bakground = \"red\"", "1:1", "unknown key 'bakground' in the scene", "did you mean 'background'?"},
        {"\n[cammera]\n", "2:2", "unknown key 'cammera'", "did you mean 'camera'?"},
        {"[camera]\nfov = 60", "2:1", "unknown key 'fov' in [camera]", "expected one of eye, center, right, up"},
        {"[camera]\neye = [0, 0]", "2:7", "found 2 values", "expected 'eye' as three finite numbers [x, y, z]"},
        {"[camera]\neye = [0, 0, inf]", "2:14", "found inf", "three finite numbers"},
        {"[camera]\nup = [1, 50, 0]", "2:6", "'up' is not perpendicular to 'right'", "expected perpendicular"},
        {"[camera]\nup = [0, 50.001, 0]", "2:6", "'right' and 'up' are not equally long", "within 1e-6"},
        {"[camera]\neye = [7, 7, 100]", "2:7", "'eye' lies in the screen's plane", "an eye off the screen's plane"},
        {"[camera]\nup = [0, 0, 0]", "2:6", "'up' is zero", ""},
        {sphere("radius = 3"), "1:1", "[[sphere]] 1 has no 'center'", ""},
        {sphere("radius = 0" + rest), "2:10", "found 0", "expected 'radius' above 0"},
        {sphere("radius = -1.5" + rest), "2:10", "found -1.5", "expected 'radius' above 0"},
        {sphere("radius = nan" + rest), "2:10", "found nan", "expected 'radius' as a finite number above 0"},
        {sphere("radius = \"3\"" + rest), "2:10", "found '3'", "expected 'radius' as a finite number"},
        {sphere("radius = 3\ncenter = [0, 0, 9]\ncolor = [1, 2, 256]"), "4:16", "found 256",
         "whole numbers [R, G, B] from 0 to 255"},
        {sphere("radius = 3\ncenter = [0, 0, 9]\ncolor = [1, 2.0, 3]"), "4:13", "found 2.0", "whole numbers"},
        {sphere("radius = 3\nhiden = true" + rest), "3:1", "unknown key 'hiden' in [[sphere]] 1", "did you mean 'hidden'?"},
        {sphere("radius = 3\nhidden = 1" + rest), "3:10", "found 1", "'hidden' as true or false"},
        {"spheres = \"\"\"\n1\n1 2 3 0 0 9 x\"\"\"", "3:13", "found 'x'", "expected the radius of sphere 1 of 1, a number"},
        {"spheres = \"2 1 2 3 0 0 9 1\"", "1:27", "the text ends", "expected the red of sphere 2 of 2"},
        {"spheres = \"0\"\n[[sphere]]", "1:11", "both 'spheres' and [[sphere]]", "only one"},
    };
    for (const BadScene& bad : cases) expect_refused("scene.toml", bad);
}

TEST(BadScene, AFolderOrAMissingFileIsNamed) {
    const TemporaryFolder folder;
    folder.write("folder/file", "");
    const Outcome directory = render(folder, {"folder"});
    EXPECT_EQ(directory.status, 2) << directory;
    EXPECT_EQ(directory.errors, "folder: cannot be read: it is a folder; expected a file\n");
    EXPECT_TRUE(fails(render(folder, {"missing.txt"}), 2, "missing.txt: cannot be read: No such file or directory\n"));
}

TEST(BadScene, NothingFromOutsideSteersTheTerminalOrForgesALine) {
    const TemporaryFolder folder;
    const std::string name = "a\x1b[2J\nb.txt: fine";
    folder.write(name, "x\x1b[2J");
    EXPECT_EQ(render(folder, {name}).errors,
              "a\\x1b[2J\\x0ab.txt: fine:1:1: found 'x\\x1b[2J', expected the number of spheres, a whole number\n");
    EXPECT_TRUE(fails(render(folder, {"missing\nb.txt: fine"}), 2, "missing\\x0ab.txt: fine: cannot be read"));
    folder.write("c\x1b.txt", red_scene);
    const Outcome verbose = render(folder, {"c\x1b.txt", "-v"});
    EXPECT_EQ(verbose.status, 0) << verbose;
    EXPECT_FALSE(contains(verbose.errors, "\x1b")) << verbose;
    folder.write("d.toml", "spheres = '1 255 0 0 0 0 200 20'\nbackground = 'blue'\n[names]\n0 = \"\\u001b[2J\\n\"\n");
    Command explain{.arguments = {"explain", "c\x1b.txt", "--pixel", "500,500"}, .folder = folder.path()};
    EXPECT_FALSE(contains(run(explain).output, "\x1b"));
    explain.arguments[1] = "d.toml";
    EXPECT_TRUE(contains(run(explain).output, R"('\x1b[2J\x0a')"));
}

TEST(BadScene, StandardInputIsCalledStdin) {
    const TemporaryFolder folder;
    Command command = cpu_render(folder, {"-"});
    command.input = bad_scene;
    EXPECT_TRUE(fails(run(command), 2, "stdin:4:1: found '-5', expected the radius"));
}

TEST(GoodScene, MayHaveAByteOrderMarkOddLineEndsOrNone) {
    const std::string mark = "\xEF\xBB\xBF";
    for (const std::string& scene :
         {mark + red_scene, std::string("1\r\n255 0 0\r\n0 0 200\r\n20"), std::string("1\r255 0 0\r0 0 200\r20\r"),
          std::string("1 255 0 0 0 0 200 20"), std::string("+1\n\n255\t0 0\f0 0\v2e2\n+20.0"),
          mark + "# comment\r\nspheres = '''1 255 0 0 0 0 200 20'''\r\n"}) {
        EXPECT_EQ(picture_of(scene, "cpu", {"-s", "5x5"}).at(2, 2), (std::vector<int>{255, 0, 0})) << testing::PrintToString(scene);
    }
    EXPECT_EQ(picture_of("0", "cpu", {"-s", "5x5"}), plain_picture(5, 5, {0, 0, 0}));
}

TEST(GoodScene, IsRecognisedByItsContentBeforeItsName) {
    const TemporaryFolder folder;
    folder.write("text.toml", red_scene);
    folder.write("toml.txt", "spheres = \"1 255 0 0 0 0 200 20\"");
    ASSERT_EQ(render(folder, {"text.toml", "toml.txt", "-s", "5x5"}).status, 0);
    EXPECT_EQ(decode_png(folder.read("text.png")).at(2, 2), (std::vector<int>{255, 0, 0}));
    EXPECT_EQ(folder.read("text.png"), folder.read("toml.png"));
}

}  // namespace
}  // namespace sphereview::test

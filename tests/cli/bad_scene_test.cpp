// What a person is told of a scene that is no scene, and where.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// The readers' own tests (tests/unit) have every message.
TEST(BadScene, IsRefusedWithItsPlaceWhatWasFoundAndExpected) {
    struct Case {
        std::string content;
        std::string said;  // behind the file's name
    };
    const std::string head = "1\n1 2 3\n0 0 9\n";
    const std::vector<Case> text = {
        {"", "1:1: the text is empty, expected the number of spheres"},
        {"\x7f"
         "ELF",
         "1:1: found '\\x7fELF', expected the number of spheres"},
        {"\n# two\n2\n", "2:1: found '#', expected the number of spheres: only TOML has comments"},
        {head + "  x\n", "4:3: found 'x', expected the radius of sphere 1 of 1, a number"},
    };
    const std::vector<Case> toml = {
        {"hello", "1:6: this is not TOML"},
        {"\n[cammera]\n", "2:2: found the unknown key 'cammera' in the scene"},
        {"[camera]\nup = [0, 0, 0]", "2:6: found a camera that cannot be used: 'up' is zero"},
        {"spheres = \"\"\"\n1\n1 2 3 0 0 9 x\"\"\"", "3:13: found 'x', expected the radius of sphere 1 of 1, a number"},
    };
    for (const auto& [name, cases] : {std::pair("scene.txt", text), {"scene.toml", toml}}) {
        for (const auto& [content, said] : cases) {
            const TemporaryFolder folder;
            folder.write(name, content);
            EXPECT_TRUE(fails(render(folder, {name, "-s", "5x5"}), 2, std::string(name) + ":" + said));
            EXPECT_EQ(folder.names(), std::vector<std::string>{name});
        }
    }
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
    const Outcome verbose = render(folder, {"c\x1b.txt", "--verbose"});
    EXPECT_EQ(verbose.status, 0) << verbose;
    EXPECT_FALSE(contains(verbose.errors, "\x1b")) << verbose;
    folder.write("d.toml", "spheres = '1 255 0 0 0 0 200 20'\nbackground = 'white'\n[names]\n0 = \"\\u001b[2J\\n\"\n");
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

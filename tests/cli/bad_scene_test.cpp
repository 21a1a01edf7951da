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
         "XYZ",
         "1:1: found '\\x7fXYZ', expected the number of spheres"},
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

}  // namespace
}  // namespace sphereview::test

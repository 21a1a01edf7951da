// Converting between the formats; the examples in scenes/.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>

#include "cli/fails.hpp"
#include "support/folders.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

constexpr const char* rich_toml = R"(background = "#102030"

[camera]
eye = [1.0, 2.0, 3.5]
center = [0.0, 0.0, 50.0]
right = [10.0, 0.0, 0.0]
up = [0.0, 10.0, 0.0]

[[sphere]]
name = "A \"b\" é"
color = [1, 2, 3]
center = [0.1, 1e+300, -0.0]
radius = 5e-324

[[sphere]]
color = [255, 0, 0]
center = [0.0, 0.0, 100.0]
radius = 3.0
hidden = true
)";

// Doubles that a careless writer or reader would change.
constexpr const char* hard_text =
    "2\n"
    "255 0 1\n0.1 -0 1.7976931348623157e+308\n5e-324\n"
    "0 255 2\n0.30000000000000004 2.2250738585072014e-308 -123456789.12345679\n1e+22\n";

class Convert : public testing::Test {
protected:
    Outcome convert(const std::vector<std::string>& arguments, const std::string& input = "") const {
        Command command;
        command.arguments = {"convert"};
        command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
        command.folder = folder_.path();
        command.input = input;
        return run(command);
    }

    TemporaryFolder folder_;
};

TEST_F(Convert, ThereAndBackGivesTheSameBytes) {
    folder_.write("scene.txt", hard_text);
    folder_.write("rich.toml", rich_toml);
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"scene.txt", "scene.toml"}, {"scene.toml", "again.txt"}, {"rich.toml", "rich2.TOML"}}) {
        const Outcome outcome = convert({from, to});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.output + outcome.errors, "");
    }
    EXPECT_EQ(folder_.read("again.txt"), hard_text);
    EXPECT_EQ(folder_.read("rich2.TOML"), rich_toml);
    EXPECT_TRUE(contains(folder_.read("scene.toml"), "[[sphere]]"));
}

TEST_F(Convert, ManySpheresWithoutNamesAreWrittenAsOneText) {
    folder_.write("many.txt", many_spheres(1001));
    folder_.write("fewer.txt", many_spheres(1000));
    ASSERT_EQ(convert({"many.txt", "many.toml"}).status, 0);
    ASSERT_EQ(convert({"fewer.txt", "fewer.toml"}).status, 0);
    EXPECT_TRUE(folder_.read("many.toml").starts_with("spheres = \"\"\"\n1001\n"));
    EXPECT_TRUE(folder_.read("fewer.toml").starts_with("[[sphere]]\n"));
    ASSERT_EQ(convert({"many.toml", "again.txt"}).status, 0);
    ASSERT_EQ(convert({"many.txt", "plain.txt"}).status, 0);
    EXPECT_EQ(folder_.read("again.txt"), folder_.read("plain.txt"));
}

TEST_F(Convert, ToChoosesTheFormatWhateverTheNameIs) {
    folder_.write("scene.txt", hard_text);
    EXPECT_TRUE(convert({"scene.txt", "-", "--to", "toml"}).output.starts_with("[[sphere]]\n"));
    EXPECT_EQ(convert({"scene.txt", "-", "--to", "text"}).output, hard_text);
    ASSERT_EQ(convert({"scene.txt", "odd.toml", "--to", "text"}).status, 0);
    EXPECT_EQ(folder_.read("odd.toml"), hard_text);
    ASSERT_EQ(convert({"scene.txt", "odd.dat", "--to", "toml"}).status, 0);
    EXPECT_TRUE(folder_.read("odd.dat").starts_with("[[sphere]]\n"));
    EXPECT_EQ(convert({"-", "-", "--to", "text"}, hard_text).output, hard_text);
}

TEST_F(Convert, SaysWhatTheTextFormatCannotHold) {
    folder_.write("rich.toml", rich_toml);
    const Outcome outcome = convert({"rich.toml", "poor.txt"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(
        outcome.errors,
        "rich.toml: the text format cannot hold the background, the camera, the names (1), the hidden spheres (1); left out\n");
    EXPECT_EQ(folder_.read("poor.txt"), "1\n1 2 3\n0.1 1e+300 -0\n5e-324\n");
}

TEST_F(Convert, FailsLikeRender) {
    folder_.write("bad.txt", bad_scene);
    folder_.write("red.txt", red_scene);
    const auto before = folder_.names();
    struct Case {
        std::vector<std::string> arguments;
        int status;
        std::string said;
    };
    const std::vector<Case> cases = {
        {{"bad.txt", "new.toml"}, 2, "bad.txt:4:1: found '-5'"},
        {{"missing.txt", "new.toml"}, 2, "missing.txt: cannot be read"},
        {{"red.txt", "missing/new.toml"}, 4, "missing/new.toml: cannot be written: the folder missing does not exist"},
        {{"red.txt", "/dev/full"}, 4, "/dev/full: cannot be written: No space left on device"},
    };
    for (const auto& [arguments, status, said] : cases) {
        EXPECT_TRUE(fails(convert(arguments), status, said));
    }
    EXPECT_TRUE(fails(convert({"-", "new.toml"}, bad_scene), 2, "stdin:4:1: "));
    EXPECT_EQ(folder_.names(), before);
}

TEST_F(Convert, GivesTheSamePicture) {
    folder_.write("rich.toml", std::string(rich_toml) + "[[sphere]]\ncolor = [9, 8, 7]\ncenter = [0, 0, 60]\nradius = 4\n");
    ASSERT_EQ(convert({"rich.toml", "copy.toml"}).status, 0);
    ASSERT_EQ(render(folder_, {"rich.toml", "copy.toml", "-s", "50x50"}).status, 0);
    EXPECT_TRUE(folder_.read("rich.png") == folder_.read("copy.png"));
    EXPECT_TRUE(contains(decode_png(folder_.read("rich.png")).bytes, "\x09\x08\x07"));
}

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

Outcome script(const std::string& name, const std::vector<std::string>& arguments = {}) {
    Command command;
    command.program = PYTHON;
    command.arguments = {source_file("scenes/make/") + name};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    return run(command);
}

std::string first_line_as_text(const std::string& scene, const std::vector<std::string>& options = {}) {
    Command command;
    command.arguments = {"convert", scene, "-", "--to", "text"};
    command.arguments.insert(command.arguments.end(), options.begin(), options.end());
    const std::string text = run(command).output;
    return text.substr(0, text.find('\n'));
}

TEST(Examples, AreWhatTheirScriptsWrite) {
    for (const auto& [made_by, example, count] : std::vector<std::array<std::string, 3>>{
             {"helix.py", "helix.xyz", "200"}, {"crystal.py", "crystal.extxyz", "1247"}, {"packing.py", "packing.csv", "827"}}) {
        const std::string path = source_file("scenes/") + example;
        const Outcome outcome = script(made_by);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(outcome.output == content_of(path)) << made_by << " writes another " << example;
        EXPECT_EQ(first_line_as_text(path), count);
    }
    EXPECT_EQ(first_line_as_text(source_file("scenes/helix.xyz"), {"--frame", "15"}), "200");
}

TEST(Examples, TheSphereflakeHasItsSpheres) {
    const TemporaryFolder folder;
    const Outcome outcome = script("sphereflake.py", {"3"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(first_line_as_text(folder.write("flake.txt", outcome.output)), "820");
}

}  // namespace
}  // namespace sphereview::test

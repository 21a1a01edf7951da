// Converting between the formats; the examples in scenes/.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>

#include "cli/fails.hpp"
#include "cli/in_folder.hpp"
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

class Convert : public InFolder {
protected:
    Outcome convert(const std::vector<std::string>& arguments, const std::string& input = "") const {
        return sphereview(all_words({"convert"}, arguments), input);
    }
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

TEST_F(Convert, KeepsThePropertiesThatAreAskedFor) {
    folder_.write("a.csv", "x,y,z,radius,q,kind\n0,0,9,1,0.5,a\n1,0,9,1,,b\n");
    ASSERT_EQ(convert({"a.csv", "none.toml"}).status, 0);
    EXPECT_FALSE(contains(folder_.read("none.toml"), "[[property]]"));
    ASSERT_EQ(convert({"a.csv", "one.toml", "--properties", "Q"}).status, 0);
    EXPECT_TRUE(contains(folder_.read("one.toml"), "[[property]]\nname = \"q\"\nvalues = [0.5, nan]\n"));
    EXPECT_FALSE(contains(folder_.read("one.toml"), "kind"));
    ASSERT_EQ(convert({"a.csv", "all.toml", "--properties", "all"}).status, 0);
    EXPECT_TRUE(contains(folder_.read("all.toml"), "name = \"kind\"\nvalues = [\"a\", \"b\"]\n"));
    ASSERT_EQ(convert({"all.toml", "again.toml"}).status, 0);
    EXPECT_EQ(folder_.read("again.toml"), folder_.read("all.toml"));
    EXPECT_TRUE(contains(convert({"all.toml", "all.txt"}).errors, "the text format cannot hold the camera, the properties (3)"));
    EXPECT_TRUE(fails(convert({"a.csv", "new.toml", "--properties", "q,kin"}), 2,
                      "a.csv: found no property 'kin', expected one of 'radius', 'q', 'kind'; did you mean 'kind'?"));
}

TEST_F(Convert, FailsLikeRender) {
    folder_.write("bad.txt", bad_scene);
    folder_.write("red.txt", red_scene);
    const auto before = folder_.names();
    const std::vector<std::tuple<std::vector<std::string>, int, std::string>> cases = {
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

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Outcome script(const std::string& name, const std::vector<std::string>& arguments = {}) {
    return run({.arguments = all_words({source_file("scenes/make/") + name}, arguments), .program = PYTHON});
}

std::string first_line_as_text(const std::string& scene, const std::vector<std::string>& options = {}) {
    return lines(run(all_words({"convert", scene, "-", "--to", "text"}, options)).output).front();
}

TEST(Examples, AreWhatTheirScriptsWrite) {
    for (const auto& [made_by, example, count] : std::vector<std::array<std::string, 3>>{
             {"helix.py", "helix.xyz", "200"}, {"crystal.py", "crystal.extxyz", "1247"}, {"packing.py", "packing.csv", "827"}}) {
        const Outcome outcome = script(made_by);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(outcome.output == content_of(source_file("scenes/" + example))) << made_by << " writes another " << example;
        EXPECT_EQ(first_line_as_text(source_file("scenes/" + example)), count);
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

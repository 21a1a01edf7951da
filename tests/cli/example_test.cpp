// The examples in scenes/ are what the scripts beside them write, and can be read.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>

#include "support/folders.hpp"
#include "support/render.hpp"

namespace sphereview::test {
namespace {

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

}  // namespace

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

}  // namespace sphereview::test

// packaging/ci/compare, which action.yml and the image of the Containerfile run; and of what these and the workflows are made.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "support/folders.hpp"
#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

class CiCompare : public testing::Test {
protected:
    CiCompare() {
        folder_.write("scenes/red.txt", red_scene);
        folder_.write("scenes/blue.toml", "spheres = \"\"\"" + std::string(blue_scene) + "\"\"\"");
        const Outcome outcome = render(folder_, {"scenes/red.txt", "scenes/blue.toml", "-s", "5x5", "-o", "scenes/{name}.png"});
        EXPECT_EQ(outcome.status, 0) << outcome;
    }

    Outcome compare() const {
        const char* path = std::getenv("PATH");
        Command command;
        command.program = "/usr/bin/env";
        command.arguments = {"PATH=" + build_file("") + ":" + (path == nullptr ? "" : path),
                             "bash",
                             source_file("packaging/ci/compare"),
                             "scenes",
                             "out",
                             "--backend",
                             "cpu",
                             "-s",
                             "5x5"};
        command.folder = folder_.path();
        return run(command);
    }

    TemporaryFolder folder_;
};

TEST_F(CiCompare, ComparesEachSceneWithTheGoldenImageOfItsName) {
    folder_.write("scenes/new.txt", red_scene);
    Outcome outcome = compare();
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "scenes/new.txt: no golden image scenes/new.png beside it: not compared"));
    EXPECT_TRUE(contains(outcome.errors, "sphereview: 2 scenes compared"));
    EXPECT_FALSE(folder_.has("out/actual/red.png"));

    folder_.write("scenes/red.txt", blue_scene);
    outcome = compare();
    EXPECT_EQ(outcome.status, 1) << outcome;
    EXPECT_TRUE(folder_.has("out/actual/red.png") && folder_.has("out/difference/red.png"));
    EXPECT_FALSE(folder_.has("out/actual/blue.png"));

    folder_.write("scenes/blue.toml", "no scene");
    outcome = compare();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(folder_.has("out/actual/red.png"));
}

TEST_F(CiCompare, RefusesTwoScenesOfOneName) {
    folder_.write("scenes/red.xyz.gz", "");
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "scenes/red.xyz.gz: another scene has the golden image scenes/red.png, too"));
}

TEST_F(CiCompare, FailsWhereNothingIsCompared) {
    for (const char* name : {"scenes/red.png", "scenes/blue.png"}) std::filesystem::remove(folder_.path(name));
    const Outcome outcome = compare();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "found no scene with a golden image in 'scenes'"));
}

// A list of wheels has the sum of each, also of NumPy, which pip downloads.
TEST(CiInstall, TakesAListOfWheelsOnlyWithTheirSums) {
    const TemporaryFolder folder;
    for (const char* name : {"bin/python3", "bin/sphereview"}) {
        folder.write(name, "#!/bin/sh\necho \"$@\"\n");
        std::filesystem::permissions(folder.path(name), std::filesystem::perms::owner_all);
    }
    Command command;
    command.program = "/usr/bin/env";
    command.arguments = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin", "PACKAGE=wheels.txt", "bash",
                         source_file("packaging/ci/install")};
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "-m pip install --require-hashes --requirement wheels.txt\n--version\n");
}

// As GitHub leaves it for an action in the workflow's own repository.
TEST(CiInstall, SaysWhatIsMissingWithoutARepository) {
    Command command;
    command.program = "/usr/bin/env";
    command.arguments = {
        "PACKAGE=", "VERSION=", "REPOSITORY=", "SERVER=file:///nowhere", "bash", source_file("packaging/ci/install")};
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.errors,
              "it is not known from which repository to download, as with 'uses: ./': name a .deb or a wheel "
              "(the input 'package')\n");
}

// Each test as the page has it, with a golden image that is right and one that is not.
TEST(CTestOfThePage, ComparesEachSceneWithTheGoldenImageOfItsName) {
    const std::string page = TemporaryFolder().read(source_file("docs/ci.md"));
    const std::string heading = "\n## CTest\n";
    ASSERT_TRUE(contains(page, heading));
    std::istringstream lines(page.substr(page.find(heading) + heading.size()));
    std::string project = "cmake_minimum_required(VERSION 3.23)\nproject(pictures NONE)\nenable_testing()\n";
    for (std::string line; std::getline(lines, line) && !line.starts_with("#");) {
        if (line.starts_with("    ")) project += line + "\n";
    }
    const TemporaryFolder folder;
    folder.write("CMakeLists.txt", project);
    for (const char* name : {"a.1", "a.2", "two.spheres"}) {
        folder.write("scenes/" + std::string(name) + ".toml", "spheres = \"\"\"" + std::string(red_scene) + "\"\"\"");
    }
    folder.write("blue.txt", blue_scene);
    Outcome outcome = render(folder, {"scenes/a.1.toml", "scenes/a.2.toml", "scenes/two.spheres.toml", "-o", "scenes/{name}.png"});
    EXPECT_EQ(outcome.status, 0) << outcome;

    Command command;
    command.folder = folder.path();
    command.environment = {{"SPHEREVIEW_BACKEND", "cpu"}};
    command.program = CMAKE;
    command.arguments = {"-G", "Ninja", "-DSPHEREVIEW=" + build_file("sphereview"), "-S", ".", "-B", "build"};
    outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    command.program = (std::filesystem::path(CMAKE).parent_path() / "ctest").string();
    command.arguments = {"--test-dir", "build"};
    outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "100% tests passed, 0 tests failed out of 3")) << outcome;

    folder.write("scenes/two.spheres.toml", "spheres = \"\"\"" + std::string(blue_scene) + "\"\"\"");
    outcome = run(command);
    EXPECT_NE(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "1 tests failed out of 3") && contains(outcome.output, "picture.two.spheres (Failed)"))
        << outcome;
    EXPECT_TRUE(folder.has("build/two.spheres-difference.png"));
}

// A tag can be moved to something that nobody has looked at.
TEST(Supply, IsNamedByWhatCannotBeMoved) {
    const std::regex action(R"(\s*(- )?uses: \S+@[0-9a-f]{40}( #.*)?)");
    const std::regex image(R"((\s*(- |container: )|FROM )\S*debian:\w+@sha256:[0-9a-f]{64})");
    const std::regex variable(R"(\s*container: \$\{\{ matrix\.image \}\})");
    int looked_at = 0;
    for (const char* name : {".github/workflows/ci.yml", ".github/workflows/release.yml", "action.yml", "Containerfile"}) {
        std::ifstream file(source_file(name));
        ASSERT_TRUE(file) << name;
        for (std::string line; std::getline(file, line);) {
            const auto has = [&](const char* part) { return line.find(part) != std::string::npos; };
            if (line.starts_with("#") || !(has("uses: ") || has("container: ") || has("- debian") || has("FROM "))) continue;
            EXPECT_TRUE(std::regex_match(line, action) || std::regex_match(line, image) || std::regex_match(line, variable))
                << name << ": " << line;
            ++looked_at;
        }
    }
    EXPECT_GT(looked_at, 20);
    // What is taken of vcpkg, and its scripts.
    std::ifstream libraries(source_file("vcpkg.json"));
    const std::string baseline = Json::parse(libraries)["builtin-baseline"];
    std::ifstream project(source_file("pyproject.toml"));
    for (std::string line; std::getline(project, line);) {
        if (line.find("git clone") != std::string::npos) {
            EXPECT_TRUE(contains(line, "checkout --quiet " + baseline));
        }
    }
}

}  // namespace
}  // namespace sphereview::test

// packaging/ci/compare, which action.yml and the image of the Containerfile run.
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/folders.hpp"
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

}  // namespace
}  // namespace sphereview::test

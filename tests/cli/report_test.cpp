// What --timings, --json and --verbose print.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

const std::vector<std::string> phases = {"read",      "context", "shaders", "lists",  "prepare", "trace",
                                         "read back", "resolve", "light",   "encode", "write"};

const std::string one_tile = "red.txt: tiles of 8 pixels, candidates: 1, in the longest list: 1; spheres in memory";

class Report : public testing::Test {
protected:
    Report() {
        folder_.write("red.txt", red_scene);
        folder_.write("bad.txt", bad_scene);
        folder_.write("two.txt", "2 1 2 3 0 0 200 20 255 0 0 0 0 100 10");
    }
    TemporaryFolder folder_;
};

TEST_F(Report, TimingsAreOneLineAPhaseInOrderThenTheDecisionsOnStandardError) {
    const Outcome outcome = render(folder_, {"red.txt", "-s", "5x5", "--timings"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "");
    const std::vector<std::string> said = lines(outcome.errors);
    ASSERT_EQ(said.size(), phases.size() + 2) << outcome;
    EXPECT_EQ(said[phases.size()], one_tile);
    EXPECT_EQ(said.back(), "red.txt: pixels decided: 25 in float, 0 in double, 0 exactly");
    for (std::size_t i = 0; i < phases.size(); ++i) EXPECT_TRUE(matches(said[i], phases[i] + " +[0-9]+\\.[0-9]{3} ms"));
}

TEST_F(Report, JsonIsOneLineASceneOnStandardOutput) {
    const Outcome outcome = render(folder_, {"red.txt", "bad.txt", "two.txt", "-s", "7x5", "--json", "-o", "out-{name}.png"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(lines(outcome.errors).size(), 2U) << outcome;
    const std::vector<std::string> rows = lines(outcome.output);
    ASSERT_EQ(rows.size(), 3U) << outcome;

    Json good = Json::parse(rows[0]);
    ASSERT_EQ(good["timings_ms"].size(), phases.size());
    for (const std::string& phase : phases) EXPECT_GE(good["timings_ms"][phase].get<double>(), 0.0) << phase;
    EXPECT_GT(good["timings_ms"]["encode"].get<double>(), 0.0);
    good.erase("timings_ms");
    good.erase("decided");  // Samples.AreReported has the points
    EXPECT_EQ(good, Json::parse(R"({"scene": "red.txt", "status": 0, "error": null, "warnings": [], "output": "out-red.png",
        "size": [7, 5],
        "spheres": 1, "properties": [], "backend": "cpu", "renderer": "cpu", "passed_over": [], "notes": [], "spheres_in": "memory", "samples": 1,
        "shade": "flat", "tiles": {"sides": [8], "candidates": 1, "longest_list": 1}})"));

    const Json bad = Json::parse(rows[1]);
    EXPECT_EQ(bad["scene"], "bad.txt");
    EXPECT_EQ(bad["status"], 2);
    EXPECT_TRUE(bad["error"].get<std::string>().starts_with("bad.txt:4:1: found '-5'"));
    EXPECT_EQ(bad["backend"], nullptr);
    EXPECT_EQ(Json::parse(rows[2])["spheres"], 2);
}

TEST_F(Report, JsonHoldsTheComparison) {
    folder_.write("golden.png", encode_png(plain_picture(5, 5, {0, 10, 0})));
    const Outcome outcome = render(folder_, {"red.txt", "-s", "5x5", "--json", "--expect", "golden.png"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(report["status"], 1);
    EXPECT_EQ(report["output"], nullptr);
    EXPECT_EQ(report["comparison"], Json::parse(R"({"expected": "golden.png", "equal": false, "same_size": true,
        "different_pixels": 25, "largest_difference": [255, 10, 0, 0], "first": [0, 0]})"));
}

TEST_F(Report, JsonNamesNoFirstDifferentPixelWhereThereIsNone) {
    ASSERT_EQ(render(folder_, {"red.txt", "-s", "5x5", "-o", "golden.png"}).status, 0);
    const Outcome equal = render(folder_, {"red.txt", "-s", "5x5", "--json", "--expect", "golden.png"});
    EXPECT_EQ(Json::parse(equal.output)["comparison"]["first"], nullptr);
    const Outcome larger = render(folder_, {"red.txt", "-s", "6x5", "--json", "--expect", "golden.png"});
    EXPECT_EQ(Json::parse(larger.output)["comparison"]["first"], nullptr);
}

TEST_F(Report, JsonIsUtf8WhateverThePathsAre) {
    folder_.write("\xFF\"\n.txt", red_scene);
    const Outcome outcome = render(folder_, {"\xFF\"\n.txt", "-s", "5x5", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(lines(outcome.output).size(), 1U);
    EXPECT_EQ(Json::parse(outcome.output)["scene"], "\xEF\xBF\xBD\"\n.txt");
}

TEST_F(Report, JsonThatCannotBeWrittenStopsNoPicture) {
    for (const StandardOutput output : {StandardOutput::full_disk, StandardOutput::closed_pipe}) {
        Command command = cpu_render(folder_, {"red.txt", "bad.txt", "two.txt", "-s", "5x5", "--json", "-o", "out-{name}.png"});
        command.output = output;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 4) << outcome;
        const std::vector<std::string> said = lines(outcome.errors);
        ASSERT_EQ(said.size(), 3U) << outcome;
        EXPECT_TRUE(said[0].starts_with("stdout: cannot be written: ")) << outcome;
        EXPECT_TRUE(said[1].starts_with("bad.txt:4:1: ")) << outcome;
        EXPECT_EQ(said[2], "sphereview: 1 of 3 scenes failed: bad.txt");
        EXPECT_TRUE(folder_.has("out-red.png") && folder_.has("out-two.png"));
        std::filesystem::remove(folder_.path("out-two.png"));
    }
}

TEST_F(Report, VerboseNamesTheBackendAndHowPixelsWereDecidedOnStandardError) {
    const Outcome outcome = render(folder_, {"red.txt", "two.txt", "-s", "5x5", "--verbose"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(outcome.errors,
              "red.txt: backend: cpu\n" + one_tile +
                  "\nred.txt: pixels decided: 25 in float, 0 in double, 0 exactly\n"
                  "two.txt: backend: cpu\ntwo.txt: tiles of 8 pixels, candidates: 2, in the longest list: 2; spheres in memory\n"
                  "two.txt: pixels decided: 25 in float, 0 in double, 0 exactly\n");
}

TEST_F(Report, WithoutCertifyingNothingIsCounted) {
    const Outcome outcome = render(folder_, {"red.txt", "-s", "5x5", "--verbose", "--no-certify"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "red.txt: backend: cpu\n" + one_tile + "\n");
}

}  // namespace
}  // namespace sphereview::test

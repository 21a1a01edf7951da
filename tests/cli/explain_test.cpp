// The arithmetic of one pixel, as the program tells it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/fails.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

using Json = nlohmann::json;

// At 3x3 the centre pixel's ray is the axis: D = (0, 0, 100).
Outcome explain(const std::string& scene, std::vector<std::string> options) {
    options.insert(options.begin(), {"explain", "-", "-s", "3x3", "-p", "1,1"});
    return run({.arguments = options, .input = scene});
}

Json explain_as_json(const std::string& scene) {
    const Outcome outcome = explain(scene, {"--json"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
    return Json::parse(outcome.output);
}

TEST(Explain, GivesTheTermsOfTheQuadraticAndItsRoots) {
    // a = 10000, b = 2 * 100 * -300, c = 90000 - 2500, discriminant = 60000^2 - 40000 c; t = (60000 -+ 10000) / 20000.
    const Json json = explain_as_json("1 255 0 9 0 0 300 50");
    ASSERT_EQ(json["hits"].size(), 1U);
    const Json& hit = json["hits"][0];
    EXPECT_EQ(hit["a"], 10000.0);
    EXPECT_EQ(hit["b"], -60000.0);
    EXPECT_EQ(hit["c"], 87500.0);
    EXPECT_EQ(hit["discriminant"], 1e8);
    EXPECT_EQ(hit["discriminant_sign"], 1);
    EXPECT_EQ(hit["t1"], 2.5);
    EXPECT_EQ(hit["t2"], 3.5);
    EXPECT_EQ(hit["counts"], "t1");
    EXPECT_EQ(hit["point"], Json({0.0, 0.0, 250.0}));
    EXPECT_EQ(hit["normal"], Json({0.0, 0.0, -1.0}));
    EXPECT_EQ(json["direction"], Json({0.0, 0.0, 100.0}));
    EXPECT_EQ(json["visible"], 0);
    EXPECT_EQ(json["color"], Json({255, 0, 9}));
    EXPECT_EQ(json["decided_in"], "float");
}

TEST(Explain, OrdersTheHitsAndCountsTheOthers) {
    const Json json = explain_as_json("4 1 1 1 0 0 900 50  2 2 2 0 0 300 50  3 3 3 500 0 300 50  4 4 4 0 0 -300 50");
    ASSERT_EQ(json["hits"].size(), 2U);
    EXPECT_EQ(json["hits"][0]["sphere"], 1);
    EXPECT_EQ(json["hits"][1]["sphere"], 0);
    EXPECT_EQ(json["missed"], 1);
    EXPECT_EQ(json["behind"], 1);
    EXPECT_EQ(json["visible"], 1);
}

TEST(Explain, SaysWhichRootCountsInsideAndOnASurface) {
    const Json inside = explain_as_json("1 1 1 1 0 0 100 150");
    EXPECT_EQ(inside["hits"][0]["eye"], "inside");
    EXPECT_EQ(inside["hits"][0]["t1"], -0.5);
    EXPECT_EQ(inside["hits"][0]["t"], 2.5);
    const Json surface = explain_as_json("1 1 1 1 0 0 100 100");
    EXPECT_EQ(surface["hits"][0]["eye"], "on the surface");
    EXPECT_EQ(surface["hits"][0]["t1"], 0.0);
    EXPECT_EQ(surface["hits"][0]["counts"], "t2");
    EXPECT_EQ(surface["hits"][0]["t"], 2.0);
}

TEST(Explain, SaysThatOnlyExactArithmeticDecidesATangentRay) {
    const Json json = explain_as_json("1 1 1 1 50 0 300 50");
    EXPECT_EQ(json["hits"][0]["discriminant"], 0.0);
    EXPECT_EQ(json["hits"][0]["discriminant_sign"], 0);
    EXPECT_EQ(json["hits"][0]["t1"], 3.0);
    EXPECT_EQ(json["hits"][0]["t2"], 3.0);
    EXPECT_EQ(json["decided_in"], "exact");
}

TEST(Explain, GivesATieToTheFirstInTheFile) {
    const Json json = explain_as_json("2 1 1 1 0 0 300 50 2 2 2 0 0 350 100");
    ASSERT_EQ(json["hits"].size(), 2U);
    EXPECT_EQ(json["visible"], 0);
    EXPECT_EQ(json["hits"][1]["as_near_as_last"], true);
    EXPECT_EQ(json["decided_in"], "exact");
}

TEST(Explain, HasNoNumberWhereADoubleCannotHoldIt) {
    const Json json = explain_as_json("1 1 1 1 0 0 1e300 1e299");
    EXPECT_EQ(json["hits"][0]["c"], nullptr);
    EXPECT_EQ(json["hits"][0]["discriminant_sign"], 1);
    EXPECT_EQ(json["visible"], 0);
}

TEST(Explain, ShowsNothingThatContradictsWhatWasDecided) {
    const std::string small = "(above 0, too small for a double to show; decided exactly)";
    const std::string large = "(above 0, too large for a double to show; decided exactly)";
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {"1 1 1 1 0 0 1e-200 1e-201", {"c = (O - C).(O - C) - r^2   = " + small, "4 a c  = " + small + "  > 0: two roots"}},
        {"1 1 1 1 0 0 1e300 1e299", {"c = (O - C).(O - C) - r^2   = " + large, "4 a c  = " + large + "  > 0: two roots"}},
        {"1 1 1 1 0 0 1e300 1e-200",
         {"(larger than t1 by too little for a double to show)", "normal (point - C) / r = (0, 0, -1)"}},
        {"camera = {eye = [0, 0, -1.7e308], center = [0, 0, 1.7e308]}\nspheres = '1 1 1 1 0 0 1e308 1e307'",
         {"D = (0, 0, (too large for a double))", "b = 2 D.(O - C)             = (below 0, too large"}},
        {"1 1 1 1 0 0 0 150", {"b = 2 D.(O - C)             = 0\n", "normal (point - C) / r = (0, 0, 1)"}},
    };
    for (const auto& [scene, parts] : cases) {
        const Outcome outcome = explain(scene, {});
        EXPECT_EQ(outcome.status, 0) << outcome;
        for (const std::string& part : parts) EXPECT_TRUE(contains(outcome.output, part));
        for (const char* never : {"inf", "-0,", "-0)", "= -0", "= 0  > 0"}) {
            EXPECT_EQ(outcome.output.find(never), std::string::npos) << never << outcome;
        }
    }
    EXPECT_EQ(explain_as_json("1 1 1 1 0 0 0 150")["hits"][0]["b"].dump(), "0.0");
}

TEST(Explain, TellsTheSameInWords) {
    const Outcome outcome = explain("1 255 0 9 0 0 300 50", {});
    EXPECT_EQ(outcome.status, 0) << outcome;
    for (const char* said : {"pixel 1,1 of stdin at 3x3", "D = (0, 0, 100)", "b = 2 D.(O - C)             = -60000",
                             "= 1e+08  > 0: two roots", "the smaller, t1, counts", "visible: sphere 0", "colour: 255 0 9"}) {
        EXPECT_TRUE(contains(outcome.output, said)) << outcome;
    }
}

TEST(Explain, TellsWhatANothingPixelShows) {
    const Outcome outcome = explain("0", {"--background", "white"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "colour: the background, white")) << outcome;
}

TEST(Explain, ReportsABadSceneLikeTheOthers) { EXPECT_TRUE(fails(explain("1 255 0", {}), 2, "stdin:1:8: ")); }

}  // namespace
}  // namespace sphereview::test

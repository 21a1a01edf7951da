// The arithmetic of one pixel, as the program tells it.
#include <gtest/gtest.h>

#include "cli/fails.hpp"
#include "support/json.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

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

// What is explained, a scene, how many spheres the ray hits, and members of the report.
const std::vector<std::tuple<const char*, const char*, std::size_t, const char*>> explained = {
    // a = 10000, b = 2 * 100 * -300, c = 90000 - 2500, discriminant = 60000^2 - 40000 c; t = (60000 -+ 10000) / 20000.
    {"the terms of the quadratic and its roots", "1 255 0 9 0 0 300 50", 1,
     R"({"/hits/0/a": 10000.0, "/hits/0/b": -60000.0, "/hits/0/c": 87500.0, "/hits/0/discriminant": 1e8,
         "/hits/0/discriminant_sign": 1, "/hits/0/t1": 2.5, "/hits/0/t2": 3.5, "/hits/0/counts": "t1",
         "/hits/0/point": [0.0, 0.0, 250.0], "/hits/0/normal": [0.0, 0.0, -1.0], "/direction": [0.0, 0.0, 100.0],
         "/visible": 0, "/color": [255, 0, 9], "/decided_in": "float"})"},
    {"hits in order, the others counted", "4 1 1 1 0 0 900 50  2 2 2 0 0 300 50  3 3 3 500 0 300 50  4 4 4 0 0 -300 50", 2,
     R"({"/hits/0/sphere": 1, "/hits/1/sphere": 0, "/missed": 1, "/behind": 1, "/visible": 1})"},
    {"the root that counts inside", "1 1 1 1 0 0 100 150", 1, R"({"/hits/0/eye": "inside", "/hits/0/t1": -0.5, "/hits/0/t": 2.5})"},
    {"the root that counts on a surface", "1 1 1 1 0 0 100 100", 1,
     R"({"/hits/0/eye": "on the surface", "/hits/0/t1": 0.0, "/hits/0/counts": "t2", "/hits/0/t": 2.0})"},
    {"a tangent ray, which only exact arithmetic decides", "1 1 1 1 50 0 300 50", 1,
     R"({"/hits/0/discriminant": 0.0, "/hits/0/discriminant_sign": 0, "/hits/0/t1": 3.0, "/hits/0/t2": 3.0,
         "/decided_in": "exact"})"},
    {"a tie, which goes to the first in the file", "2 1 1 1 0 0 300 50 2 2 2 0 0 350 100", 2,
     R"({"/visible": 0, "/hits/1/as_near_as_last": true, "/decided_in": "exact"})"},
    {"no number where a double cannot hold it", "1 1 1 1 0 0 1e300 1e299", 1,
     R"({"/hits/0/c": null, "/hits/0/discriminant_sign": 1, "/visible": 0})"},
};

TEST(Explain, GivesTheArithmeticOfThePixel) {
    for (const auto& [what, scene, hits, members] : explained) {
        SCOPED_TRACE(what);
        const Json json = explain_as_json(scene);
        const Json expected = Json::parse(members);
        for (const auto& [place, value] : expected.items()) EXPECT_EQ(json.at(Json::json_pointer(place)), value) << place;
        EXPECT_EQ(json["hits"].size(), hits);
    }
}

TEST(Explain, TellsThePropertiesThatAreAskedFor) {
    const std::string table = "x,y,z,radius,q,kind\n0,0,300,50,-0.5,a\n0,0,500,50,,b\n";
    const std::vector<std::string> straight = {"--no-fit", "--properties", "q,kind"};
    EXPECT_TRUE(contains(explain(table, straight).output, "  q = -0.5, kind = 'a'\n"));
    EXPECT_FALSE(contains(explain(table, {"--no-fit"}).output, "q ="));
    const Json json = Json::parse(explain(table, {"--no-fit", "--json", "--properties", "q,kind"}).output);
    EXPECT_EQ(json["hits"][0]["properties"], Json::parse(R"({"q": -0.5, "kind": "a"})"));
    EXPECT_EQ(json["hits"][1]["properties"], Json::parse(R"({"q": null, "kind": "b"})"));
    EXPECT_FALSE(explain_as_json("1 1 1 1 0 0 300 50")["hits"][0].contains("properties"));
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

// The middle pixel sees (0, 0, 180); the second sphere touches the line from there in the direction (1, 0, -1).
TEST(Explain, TellsWhyTheSunDoesNotShine) {
    const std::string scene = "2 200 30 40 0 0 200 20 0 200 0 40 5 140 5";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"1,0,-1", R"({"/sun/shines": false, "/sun/facing_sign": 1, "/sun/blocker": 1, "/sun/along_sign": -1, "/sun/disc_sign": 0,
                       "/light": [0, 0, 0], "/color": [0, 0, 0]})"},
        {"1,0.1,-1", R"({"/sun/shines": false, "/sun/blocker": 1, "/sun/disc_sign": 1, "/color": [0, 0, 0]})"},
        {"1,0,0", R"({"/sun/shines": false, "/sun/facing_sign": 0, "/sun/blocker": null, "/color": [0, 0, 0]})"},
        {"0,0,1", R"({"/sun/shines": false, "/sun/facing_sign": -1, "/color": [0, 0, 0]})"},
        {"1,-1e-9,-1", R"({"/sun/shines": true, "/sun/blocker": null})"},
        {"180,0", R"({"/sun/shines": false, "/sun/direction": [0.0, 0.0, 1.0], "/sun/facing_sign": -1})"},
        {"0,0,-3", R"({"/sun/shines": true, "/light": [0, 0, -268435456], "/color": [200, 30, 40]})"},
    };
    for (const auto& [sun, members] : cases) {
        const Outcome outcome = explain(scene, {"--json", "--shade", "studio", "--sky", "0", "--sun", sun});
        ASSERT_EQ(outcome.status, 0) << outcome;
        const Json json = Json::parse(outcome.output);
        const Json expected = Json::parse(members);
        for (const auto& [place, value] : expected.items()) EXPECT_EQ(json.at(Json::json_pointer(place)), value) << sun << place;
    }
    const Outcome outcome = explain(scene, {"--shade", "studio", "--sun", "1,0,-1"});
    EXPECT_TRUE(contains(outcome.output, "sphere 1 is in the way")) << outcome;
    EXPECT_TRUE(contains(outcome.output, "the line to the light touches the sphere")) << outcome;
    EXPECT_TRUE(contains(outcome.output, "sky: ")) << outcome;
    // A sun of which nothing more is said is beside a sky that leaves room for its light.
    const auto lit = [&](const std::vector<std::string>& options) {
        return explain(scene, all_words({"--shade", "studio", "--sun", "0,0,-3"}, options)).output;
    };
    EXPECT_EQ(lit({}), lit({"--sky", "0.4", "--sun-strength", "0.7"}));
    EXPECT_EQ(lit({"--sky", "1"}), lit({"--sky", "1", "--sun-strength", "1"}));
    EXPECT_EQ(lit({"--sun-strength", "2"}), lit({"--sky", "0.4", "--sun-strength", "2"}));
    EXPECT_TRUE(
        fails(explain(scene, {"--shade", "studio", "--sun-strength", "2"}), 2, "sphereview: --sun-strength: the scene has no sun"));
}

// Somebody who multiplies by hand comes to the export's colour.
TEST(Explain, TellsHowLightMakesTheColour) {
    const std::string scene = "2 200 30 140 0 0 200 20 0 200 0 40 5 140 5";
    for (const std::string pixel : {"500,500", "460,470", "530,560"}) {
        const Outcome outcome =
            run({.arguments = {"explain", "-", "--json", "--shade", "studio", "--sun", "1,2,-1", "-p", pixel}, .input = scene});
        ASSERT_EQ(outcome.status, 0) << outcome;
        const Json json = Json::parse(outcome.output);
        const Json& b = json.at("light");
        const Json& n = json.at("hits")[0].at("normal");
        double e = 0.0;
        for (std::size_t i = 0; i < 3; ++i) e += n[i].get<double>() * b[i].get<double>() / 268435456.0;
        EXPECT_NEAR(json.at("brightness").get<double>(), e, 1e-12);
        const double part = std::min(1.8 * e / (0.8 + e), 1.0);
        EXPECT_NEAR(json.at("shown_part").get<double>(), part, 1e-12);
        const std::vector<int> own = {200, 30, 140};
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(json.at("color")[i], std::floor(own[i] * part + 0.5)) << pixel;
    }
    const std::string words = explain(scene, {"--shade", "studio"}).output;
    for (const char* part : {"E = n.B = ", "s = 1.8 E / (0.8 + E) = ", "colour = s times 200 30 140 = "}) {
        EXPECT_TRUE(contains(words, part)) << words;
    }
}

// A plate over the sphere keeps all lights away but those from the sides; a small sphere few of them.
TEST(Explain, CountsTheLightsOfTheSky) {
    const std::string scene = "3 200 30 40 0 0 200 20 9 9 9 0 1060 180 1000 9 9 9 0 -15 165 8";
    const Outcome outcome = explain(scene, {"--json", "--shade", "studio", "--lights", "64"});
    ASSERT_EQ(outcome.status, 0) << outcome;
    const Json sky = Json::parse(outcome.output).at("sky");
    EXPECT_EQ(sky.at("lights"), 64);
    EXPECT_EQ(sky.at("behind"), 33) << "two of them along the surface";
    EXPECT_EQ(sky.at("shine").get<int>() + sky.at("in_shadow").get<int>(), 31);
    ASSERT_EQ(sky.at("blockers").size(), 2U) << sky.dump();
    EXPECT_EQ(sky.at("blockers")[0].at("sphere"), 1);
    EXPECT_EQ(sky.at("blockers")[1].at("sphere"), 2);
    EXPECT_EQ(sky.at("blockers")[0].at("lights").get<int>() + sky.at("blockers")[1].at("lights").get<int>(), sky.at("in_shadow"))
        << "no light goes through both";
    EXPECT_TRUE(contains(explain(scene, {"--shade", "studio", "--lights", "64"}).output,
                         "of 64 lights shine; 33 behind the surface (n.L <= 0), "));
}

// Without a sun it is the light nearest to the key light that is followed.
TEST(Explain, FollowsTheRayToOneLightOfTheSky) {
    const std::string under_plate = "2 200 30 40 0 0 200 20 9 9 9 0 1060 180 1000";
    const auto asked = [&](const std::string& scene, const std::vector<std::string>& options) {
        const Outcome outcome = explain(scene, all_words({"--json", "--shade", "studio", "--lights", "16"}, options));
        EXPECT_EQ(outcome.status, 0) << outcome;
        return Json::parse(outcome.output);
    };
    const Json nearest = asked(under_plate, {}).at("explained_light");
    EXPECT_EQ(nearest.at("shines"), false);
    EXPECT_EQ(nearest.at("facing_sign"), 1);
    EXPECT_EQ(nearest.at("blocker"), 1);
    EXPECT_EQ(nearest.at("along_sign"), -1);
    EXPECT_EQ(nearest.at("disc_sign"), 1);
    // What the lights add that shine is the whole light.
    std::vector<int> sum(3);
    double most = 0.0;
    int brightest = 0;
    for (int number = 1; number <= 16; ++number) {
        const Json light = asked(under_plate, {"--light", std::to_string(number)}).at("explained_light");
        EXPECT_EQ(light.at("number"), number);
        const auto share = light.at("share").get<std::vector<int>>();
        const double strength = std::hypot(share[0], share[1], share[2]);
        if (strength > most) brightest = number;
        most = std::max(most, strength);
        for (std::size_t axis = 0; axis < 3 && light.at("shines") == true; ++axis) sum[axis] += share[axis];
    }
    EXPECT_EQ(asked(under_plate, {}).at("light").get<std::vector<int>>(), sum);
    EXPECT_EQ(nearest.at("number"), brightest);
    const Json with_sun = asked(under_plate, {"--sun", "0,0,-1"});
    EXPECT_FALSE(with_sun.contains("explained_light"));
    EXPECT_EQ(with_sun.at("sun").at("shines"), true);
    EXPECT_EQ(asked(under_plate, {"--sun", "0,0,-1", "--light", "0"}).at("explained_light").at("shines"), true);
    EXPECT_EQ(asked(under_plate, {"--sun", "0,0,-1", "--light", "3"}).at("explained_light").at("number"), 3);

    const auto words = [&](const std::vector<std::string>& options) {
        return explain(under_plate, all_words({"--shade", "studio", "--lights", "16"}, options));
    };
    const std::string number = std::to_string(brightest);
    EXPECT_TRUE(contains(words({}).output, "light " + number + ", of the sky's the nearest to the key light: L = (")) << words({});
    EXPECT_TRUE(contains(words({}).output, ") does not shine: n.L > 0, but sphere 1 is in the way.")) << words({});
    const std::string another = "\nlight " + std::to_string(brightest == 1 ? 2 : 1) + ": L = (";
    EXPECT_TRUE(contains(words({"--light", brightest == 1 ? "2" : "1"}).output, another));
    EXPECT_EQ(words({"--light", number}).output, words({}).output) << "is said once";
}

TEST(Explain, RefusesALightThatThereIsNot) {
    const std::string scene = "1 200 30 40 0 0 200 20";
    const auto refused = [&](const std::vector<std::string>& options, const std::string& message) {
        EXPECT_TRUE(fails(explain(scene, all_words({"--shade", "studio", "--lights", "16"}, options)), 2, message));
    };
    refused({"--light", "17"}, "sphereview: --light: found 17, expected 1 to 16");
    refused({"--light", "0"}, "sphereview: --light: found 0, expected 1 to 16");
    refused({"--light", "17", "--sun", "0,0,-1"}, "sphereview: --light: found 17, expected 0 (the sun) or 1 to 16");
    refused({"--light", "1", "--sun", "0,0,-1", "--sky", "0"}, "sphereview: --light: found 1, expected 0 (the sun)");
    refused({"--light", "1", "--sky", "0"}, "sphereview: --light: found 1, expected a scene with a light");
    EXPECT_TRUE(
        fails(explain(scene, {"--shade", "studio", "--light", "one"}), 2, "sphereview: --light: found 'one', expected the number"));
    EXPECT_TRUE(fails(explain(scene, {"--light", "1"}), 2, "sphereview: --light needs --shade studio"));
}

TEST(Explain, TellsOfTheNearestOfThousandsOfHits) {
    std::string scene = "1200";
    for (int i = 0; i < 1200; ++i) scene += "  1 2 3  0 0 " + std::to_string(3000 - i) + " 50";
    const Outcome outcome = explain(scene, {});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "visible: sphere 1199, which has the smallest t\n"));
    EXPECT_TRUE(contains(outcome.output, "\nand 200 more hits, farther away\n"));
    const Json report = Json::parse(explain(scene, {"--json"}).output);
    EXPECT_EQ(report.at("hits").size(), 1000U);
    EXPECT_EQ(report.at("farther_hits"), 200);
}

TEST(Explain, TellsWhatANothingPixelShows) {
    const Outcome outcome = explain("0", {"--background", "white"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.output, "colour: the background, white")) << outcome;
}

TEST(Explain, ReportsABadSceneLikeTheOthers) { EXPECT_TRUE(fails(explain("1 255 0", {}), 2, "stdin:1:8: ")); }

}  // namespace
}  // namespace sphereview::test

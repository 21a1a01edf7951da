// Pictures of other ray tracers, and what is wrong with them.
#include <gtest/gtest.h>

#include <sstream>

#include "cli/in_folder.hpp"
#include "support/json.hpp"
#include "support/picture.hpp"
#include "support/render.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

class Compare : public InFolder {
protected:
    Compare() {
        folder_.write("scene.txt", "2  255 0 0  0 0 300 50  0 0 255  -30 0 250 30");
        render(folder_, {"scene.txt", "-s", "60x40", "-o", "right.png"});
    }

    Outcome compare(const std::vector<std::string>& arguments) { return sphereview(all_words({"compare"}, arguments)); }

    // The right picture upside down, as a PPM.
    void write_upside_down(const std::string& name) {
        const Picture right = decode_png(folder_.read("right.png"));
        std::string bytes = "P6\n60 40\n255\n";
        for (std::size_t row = 40; row-- > 0;) bytes += right.bytes.substr(row * 180, 180);
        folder_.write(name, bytes);
    }
};

TEST_F(Compare, SaysNothingElseOfAnEqualPicture) {
    const Outcome outcome = compare({"right.png", "scene.txt"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "right.png: equal to the right picture of scene.txt\n");
    EXPECT_FALSE(folder_.has("right-difference.png"));
}

TEST_F(Compare, NamesTheLikeliestMistakeAndShowsWhere) {
    folder_.write("scene.txt", "2  255 0 0  0 40 300 50  0 0 255  -30 0 250 30");
    render(folder_, {"scene.txt", "-s", "60x40", "-o", "right.png"});
    write_upside_down("mine.ppm");
    const Outcome outcome = compare({"mine.ppm", "scene.txt"});
    EXPECT_EQ(outcome.status, 1) << outcome;
    for (const char* part :
         {"likeliest mistake: y points down: the picture is upside down\n", "and contradicts none that is right\n",
          "found 0 0 0 (the background), expected 255 0 0 (sphere 0)\n    sphere 0: t1 = ",
          "more: sphereview explain scene.txt --pixel ", "picture of the difference: mine-difference.png\n"}) {
        EXPECT_TRUE(contains(outcome.output, part)) << outcome;
    }
    const Picture difference = decode_png(folder_.read("mine-difference.png"));
    EXPECT_EQ(difference.at(0, 0), (std::vector{0, 0, 0}));
    EXPECT_EQ(difference.at(30, 10), (std::vector{255, 255, 255}));
}

TEST_F(Compare, GoesThroughAClassAndReportsJson) {
    folder_.write("scene.txt", "1  255 0 0  0 40 300 50");
    render(folder_, {"scene.txt", "-s", "60x40", "-o", "right.png"});
    write_upside_down("mine.ppm");
    folder_.write("broken.png", "GIF89a");
    const Outcome outcome = compare({"right.png", "broken.png", "mine.ppm", "scene.txt", "--json", "--no-diff"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.errors, "broken.png: found a GIF picture, expected a PNG, PPM, PGM or BMP picture\n");
    std::istringstream lines(outcome.output);
    std::string line;
    std::vector<Json> reports;
    while (std::getline(lines, line)) reports.push_back(Json::parse(line));
    ASSERT_EQ(reports.size(), 3U);
    EXPECT_EQ(reports[0]["equal"], true);
    EXPECT_EQ(reports[1]["status"], 2);
    EXPECT_EQ(reports[2]["likeliest"], Json({"y-down"}));
    EXPECT_EQ(reports[2]["explained"], reports[2]["different_pixels"]);
    EXPECT_EQ(reports[2]["examples"].size(), 3U);
    EXPECT_TRUE(reports[2]["difference"].is_null());
    EXPECT_FALSE(folder_.has("mine-difference.png"));
}

TEST_F(Compare, SaysThatAPictureIsShadedOrSmoothed) {
    const std::string wants = "; compare wants flat pictures of one sample (--shade flat --samples 1)\n";
    folder_.write("scene.txt", "3  255 0 0  0 0 300 50  0 0 255  -30 0 250 30  200 200 200  60 20 280 30");
    std::vector<std::string> background_option;
    const auto style_of = [&](const std::vector<std::string>& options) {
        render(folder_, all_words(all_words({"scene.txt", "-s", "120x80", "-o", "mine.png"}, background_option), options));
        const std::vector<std::string> usual = all_words({"mine.png", "scene.txt", "--no-diff"}, background_option);
        const Outcome outcome = compare(usual);
        EXPECT_EQ(outcome.status, 1) << outcome;
        EXPECT_FALSE(contains(outcome.output, "likeliest mistake")) << outcome;
        EXPECT_TRUE(contains(outcome.output.substr(0, outcome.output.find('\n') + 1), wants)) << outcome;
        EXPECT_TRUE(contains(outcome.output, " pixels differ from the right picture of scene.txt\n")) << outcome;
        const Json report = Json::parse(compare(all_words(usual, {"--json"})).output);
        EXPECT_TRUE(outcome.output.starts_with("mine.png: " + report["style_words"].get<std::string>())) << outcome;
        EXPECT_EQ(report["likeliest"], Json::array());
        return report["style"].get<std::string>();
    };
    for (const std::string background : {"black", "white", "transparent"}) {
        background_option = {"--background", background};
        EXPECT_EQ(style_of({"--shade", "studio"}), "shaded") << background;
        EXPECT_EQ(style_of({"--shade", "studio", "--samples", "4", "--sun", "1,1,-1"}), "shaded") << background;
        EXPECT_EQ(style_of({"--shade", "headlight"}), "shaded") << background;
        EXPECT_EQ(style_of({"--samples", "4"}), "smoothed") << background;
    }
    // Flat pictures are judged as ever.
    render(folder_, {"scene.txt", "-s", "60x40", "-o", "right.png"});
    write_upside_down("mine.ppm");
    const Json flat = Json::parse(compare({"mine.ppm", "scene.txt", "--no-diff", "--json"}).output);
    EXPECT_TRUE(flat["style"].is_null()) << flat.dump();
}

TEST_F(Compare, MakesTheFolderOfAPattern) {
    folder_.write("scene.txt", "1  0 255 0  0 0 300 50");
    EXPECT_EQ(compare({"right.png", "scene.txt", "--diff", "new/{name}.png"}).status, 1);
    EXPECT_TRUE(folder_.has("new/right.png"));
    EXPECT_EQ(compare({"right.png", "scene.txt", "--diff", "other/mine.png"}).status, 4);
    EXPECT_FALSE(folder_.has("other"));
}

// Students' pictures often have one name, in folders of their own.
TEST_F(Compare, NamesFilesByTheirFolders) {
    folder_.write("scene.txt", "1  0 255 0  0 0 300 50");
    folder_.write("ann/mine.png", folder_.read("right.png"));
    folder_.write("bob/mine.png", folder_.read("right.png"));
    const Outcome same = compare({"ann/mine.png", "bob/mine.png", "scene.txt"});
    EXPECT_EQ(same.status, 2);
    EXPECT_TRUE(contains(same.errors, "use --diff with a pattern such as out/{folder}-{name}.png")) << same;
    EXPECT_EQ(compare({"ann/mine.png", "bob/mine.png", "scene.txt", "--diff", "out/{folder}.png"}).status, 1);
    EXPECT_TRUE(folder_.has("out/ann.png"));
    EXPECT_TRUE(folder_.has("out/bob.png"));
    const Outcome different = compare({"ann/mine.png", "right.png", "scene.txt", "--diff", "out.png"});
    EXPECT_TRUE(contains(different.errors, "such as out/{name}.png")) << different;
    const Outcome twice = compare({"right.png", "right.png", "scene.txt"});
    EXPECT_TRUE(contains(twice.errors, "one at a time")) << twice;
}

// What a name itself holds is no placeholder.
TEST_F(Compare, FillsInNamesOnce) {
    folder_.write("scene.txt", "1  0 255 0  0 0 300 50");
    folder_.write("{name}/{folder}.png", folder_.read("right.png"));
    EXPECT_EQ(compare({"{name}/{folder}.png", "scene.txt", "--diff", "out/{folder}-{name}.png"}).status, 1);
    EXPECT_TRUE(folder_.has("out/{name}-{folder}.png"));
}

TEST_F(Compare, RefusesWhatMakesNoSense) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"scene.txt"}, "PICTURE: found one file alone, expected pictures, and last the scene"},
        {{"-", "-"}, "PICTURE: found '-' twice, expected standard input once"},
        {{"right.png", "scene.txt", "--diff", "-"}, "--diff: found '-', expected a file: standard output has the report"},
        {{"right.png", "scene.txt", "--diff", "right.png"},
         "right.png: the picture of the difference of right.png would overwrite"},
        {{"right.png", "right.png", "scene.txt"},
         "right-difference.png: the picture of the difference of right.png would overwrite"},
        {{"right.png", "none.txt"}, "none.txt: "},
        {{"none.png", "scene.txt"}, "none.png: "},
    };
    for (const auto& [arguments, message] : cases) {
        const Outcome outcome = compare(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, message)) << outcome;
    }
}

}  // namespace
}  // namespace sphereview::test

// Colours and sizes by what a file holds: --color-by, --size-by, --radii.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/in_folder.hpp"
#include "support/json.hpp"
#include "support/picture.hpp"
#include "support/render.hpp"
#include "support/sha256.hpp"

namespace sphereview::test {
namespace {

constexpr const char* three = "3\n1 2 3\n0 0 100 1\n4 5 6\n10 0 100 2\n7 8 9\n20 0 100 4\n";

class Look : public InFolder {
protected:
    Look() { folder_.write("a.txt", three); }

    // The scene with the look, as text, and what was said.
    std::pair<std::string, std::string> converted(const std::vector<std::string>& arguments,
                                                  const std::string& file = "a.txt") const {
        const Outcome outcome = sphereview(all_words({"convert", file, "-", "--to", "text"}, arguments));
        EXPECT_EQ(outcome.status, 0) << outcome;
        return {outcome.output, outcome.errors};
    }

    Picture picture(const std::vector<std::string>& options) const {
        const Outcome outcome = render(folder_, all_words({"a.txt", "-o", "-"}, options));
        EXPECT_EQ(outcome.status, 0) << outcome;
        return decode_png(outcome.output);
    }
};

}  // namespace

TEST_F(Look, ColorsByNumbers) {
    const auto [grey, said] = converted({"--color-by", "x", "--colormap", "grey"});
    EXPECT_EQ(grey, "3\n0 0 0\n0 0 100\n1\n128 128 128\n10 0 100\n2\n255 255 255\n20 0 100\n4\n");
    EXPECT_EQ(said, "a.txt: colours by x: grey from 0 to 20\n");
    const auto [turned, range] = converted({"--color-by", "Radius", "--range", "4:0", "--colormap", "grey"});
    EXPECT_EQ(turned, "3\n191 191 191\n0 0 100\n1\n128 128 128\n10 0 100\n2\n0 0 0\n20 0 100\n4\n");
    EXPECT_EQ(range, "a.txt: colours by radius: grey from 4 to 0\n");
    EXPECT_EQ(converted({"--color-by", "radius", "--log", "--colormap", "grey"}).first,
              "3\n0 0 0\n0 0 100\n1\n128 128 128\n10 0 100\n2\n255 255 255\n20 0 100\n4\n");
}

TEST_F(Look, SizesByNumbers) {
    EXPECT_EQ(
        converted({"--size-by", "x", "--scale", "0.5"}),
        (std::pair<std::string, std::string>("3\n1 2 3\n0 0 100\n0.2\n4 5 6\n10 0 100\n5\n7 8 9\n20 0 100\n10\n",
                                             "a.txt: radii by x: 0.5 times the value; small: 1 sphere without a value above 0\n")));
    EXPECT_EQ(converted({"--size-by", "radius"}).second, "a.txt: radii by radius: 1.25 times the value\n");
    EXPECT_EQ(converted({"--radius-scale", "2"}),
              (std::pair<std::string, std::string>("3\n1 2 3\n0 0 100\n2\n4 5 6\n10 0 100\n4\n7 8 9\n20 0 100\n8\n", "")));
}

TEST_F(Look, IsInThePictureAndInItsReport) {
    const Outcome outcome =
        sphereview({"render", "a.txt", "-s", "64x64", "--backend", "cpu", "--fit", "--color-by", "x", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(report["color_by"], Json::parse(R"({"property": "x", "colormap": "viridis", "range": [0.0, 20.0], "log": false,
                                                  "without_value": 0})"));
    EXPECT_EQ(report["size_by"], nullptr);
    // The same as the picture of the converted scene.
    EXPECT_EQ(sphereview({"convert", "a.txt", "b.toml", "--fit", "--color-by", "x"}).status, 0);
    EXPECT_EQ(sphereview({"render", "b.toml", "-s", "64x64", "--backend", "cpu", "--expect", "a.png"}).status, 0);
}

TEST_F(Look, UsesWhatFilesHold) {
    folder_.write("q.xyz", "3\nProperties=species:S:1:pos:R:3:charge:R:1\nC 0 0 0 -1\nO 1 0 0 1\nC 2 0 0 nan\n");
    const auto [colors, said] = converted({"--color-by", "Charge", "--colormap", "grey", "--radius", "1"}, "q.xyz");
    EXPECT_EQ(colors, "3\n0 0 0\n0 0 0\n1\n255 255 255\n1 0 0\n1\n128 128 128\n2 0 0\n1\n");
    EXPECT_EQ(said,
              "q.xyz: colours by charge: grey from -1 to 1; 1 sphere has no value, and is grey\n"
              "q.xyz: the text format cannot hold the names (3); left out\n");
    EXPECT_EQ(converted({"--radii", "vdw", "--radius-scale", "0.5"}, "q.xyz").first,
              "3\n144 144 144\n0 0 0\n0.85\n255 13 13\n1 0 0\n0.76\n144 144 144\n2 0 0\n0.85\n");
    folder_.write("m.csv", "x,y,z,mass,kind\n0,0,0,1,a\n1,0,0,2,b\n");
    EXPECT_EQ(converted({"--size-by", "mass", "--color-by", "kind"}, "m.csv").first,
              "2\n230 159 0\n0 0 0\n0.25\n86 180 233\n1 0 0\n0.5\n");
    expect_fault(
        {"render", "m.csv", "--color-by", "maas"},
        "m.csv: found no property 'maas', expected one that the file has, mass or kind, or x, y, z or radius; did you mean "
        "'mass'?");
    expect_fault({"render", "m.csv", "--size-by", "kind"}, "m.csv: kind: found words, expected numbers, for sizes");
    const Outcome outcome = sphereview(
        {"render", "q.xyz", "-s", "20x20", "--backend", "cpu", "--color-by", "element", "--size-by", "charge", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    const Json report = Json::parse(outcome.output);
    EXPECT_EQ(report["color_by"]["categories"][0], Json::parse(R"({"name": "C", "color": [144, 144, 144], "count": 2})"));
    EXPECT_EQ(report["size_by"], Json::parse(R"({"property": "charge", "scale": 0.5, "small": 2})"));
}

TEST_F(Look, SaysWhatIsWrong) {
    expect_fault({"render", "a.txt", "--color-by", "charge"},
                 "a.txt: found no property 'charge', expected x, y, z or radius: the file has no others");
    expect_fault({"convert", "a.txt", "b.txt", "--size-by", "radios"},
                 "a.txt: found no property 'radios', expected x, y, z or radius: the file has no others; did you mean 'radius'?");
    expect_fault({"render", "a.txt", "--radii", "vdw"}, "a.txt: found no elements, expected a file of atoms for --radii");
    const std::string see = " (see 'sphereview render --help')";
    expect_fault({"render", "a.txt", "--color-by", "x", "--range", "1:1"},
                 "sphereview: --range: found '1:1', expected A:B, two different numbers" + see);
    expect_fault({"render", "a.txt", "--color-by", "x", "--log", "--range", "-1:1"},
                 "sphereview: --range: found '-1:1', expected numbers above 0 with --log" + see);
    expect_fault({"render", "a.txt", "--color-by", "x", "--colormap", "virids"},
                 "sphereview: --colormap: found 'virids', expected viridis, plasma, cividis, turbo, coolwarm or grey; did you mean "
                 "'viridis'?" +
                     see);
    expect_fault({"render", "a.txt", "--radii", "atomic"},
                 "sphereview: --radii: found 'atomic', expected covalent, vdw or ionic" + see);
    for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{{"--range", "0:1"}, {"--scale", "2"}}) {
        const Outcome outcome = sphereview({"render", "a.txt", option, value});
        EXPECT_EQ(outcome.status, 2) << outcome;
    }
}

namespace {

// Which pixels two pictures of one size differ in.
std::vector<bool> differing(const Picture& a, const Picture& b) {
    std::vector<bool> found;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) found.push_back(a.at(x, y) != b.at(x, y));
    }
    return found;
}

}  // namespace

TEST_F(Look, ALegendIsBesideOtherMarks) {
    for (const char* size : {"200x200", "200x500", "640x200"}) {
        for (const char* background : {"black", "white", "transparent"}) {
            const auto with = [&](const std::vector<std::string>& marks) {
                return picture(all_words({"--fit", "-s", size, "--color-by", "radius", "--background", background}, marks));
            };
            const Picture plain = with({});
            const std::vector<bool> legend = differing(with({"--legend"}), plain);
            const std::vector<bool> others = differing(with({"--axes", "--scale-bar"}), plain);
            const std::vector<bool> all = differing(with({"--legend", "--axes", "--scale-bar"}), plain);
            EXPECT_GT(std::ranges::count(legend, true), 500) << size;
            for (std::size_t i = 0; i < all.size(); ++i) {
                ASSERT_FALSE(legend[i] && others[i]) << size << " " << background << ": pixel " << i;
                ASSERT_EQ(all[i], legend[i] || others[i]) << size << " " << background << ": pixel " << i;
            }
        }
    }
    EXPECT_EQ(picture({"-s", "191x400", "--color-by", "x", "--legend"}), picture({"-s", "191x400", "--color-by", "x"}));
    EXPECT_EQ(sphereview({"render", "a.txt", "--legend"}).status, 2) << "of which colours?";
}

// With counts that are as numbers beside the words: 1 66 must not read as 166.
TEST_F(Look, ALegendLeavesRoomBetweenAWordAndItsCount) {
    std::string table = "x,y,z,radius,type\n";
    for (int i = 0; i < 132; ++i) table += "0,0,-100,0.1," + std::to_string(1 + i % 2) + "\n";
    folder_.write("t.csv", table);
    const auto shown = [&](std::vector<std::string> more) {
        for (const char* word : {"--no-fit", "-s", "500x500", "-o", "-", "--background", "transparent"}) more.emplace_back(word);
        more.insert(more.begin(), "t.csv");
        return decode_png(render(folder_, more).output);
    };
    const std::vector<bool> drawn = differing(shown({"--color-by", "type", "--legend"}), shown({}));
    constexpr int side = 500;
    const auto has_ink = [&](int x) {
        for (int y = 30; y < side; ++y) {  // below the title
            if (drawn[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)]) return true;
        }
        return false;
    };
    // The widest room between columns with ink, from the count at the right to the dot at the left.
    int last = side - 1;
    while (last > 0 && !has_ink(last)) --last;
    int widest = 0;
    for (int x = last; x > side - 80; --x) {
        if (!has_ink(x)) continue;
        widest = std::max(widest, last - x - 1);
        last = x;
    }
    EXPECT_GE(widest, 12);
}

TEST_F(Look, ALegendHasTheSameBytesEverywhere) {
    const Picture shown = picture({"-s", "300x300", "--fit", "--color-by", "radius", "--log", "--legend"});
    EXPECT_EQ(sha256(shown.bytes), "e4410d6de497655fa1b4cb3117a31c14e151f2526a583b69e400cf351563a248");
}

TEST_F(Look, ALegendHasOtherLettersInsteadOfThoseThatItsFontLacks) {
    const auto legend_of = [&](const std::string& name, const std::string& word) {
        folder_.write("a.csv", "x,y,z,radius," + name + "\n0,0,100,9," + word + "\n20,0,100,9,!\n");
        const Outcome outcome = render(folder_, {"a.csv", "-s", "300x300", "--color-by", name, "--legend", "-o", "-"});
        EXPECT_EQ(outcome.status, 0) << outcome;
        return decode_png(outcome.output);
    };
    EXPECT_EQ(legend_of("Gr\xC3\xB6\xC3\x9F"
                        "e",
                        "a"),
              legend_of("Grosse", "a"));
    EXPECT_EQ(legend_of("kind", "\xE9\x9B\xBB"), legend_of("kind", "?"));
}

TEST_F(Look, FindsAPropertyWithoutItsUnit) {
    folder_.write("a.csv", "x,y,z,radius,Charge [e]\n0,0,100,1,0.5\n10,0,100,2,1\n");
    const auto [grey, said] = converted({"--color-by", "charge", "--colormap", "grey"}, "a.csv");
    EXPECT_TRUE(grey.starts_with("2\n0 0 0\n")) << grey;
    EXPECT_NE(said.find("colours by Charge [e]: grey from 0.5 to 1"), std::string::npos) << said;
    // Of two neither is meant.
    folder_.write("a.csv", "x,y,z,radius,Charge [e],charge (C)\n0,0,100,1,0.5,3\n10,0,100,2,1,4\n");
    const Outcome outcome = sphereview({"render", "a.csv", "-o", "-", "--color-by", "charge"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("Charge [e]"), std::string::npos) << outcome;
}

}  // namespace sphereview::test

// Renders that are spread, and go on after an end.
#include <gtest/gtest.h>

#include <algorithm>

#include <algorithm>
#include <filesystem>

#include "cli/fails.hpp"
#include "cli/farm.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

TEST_F(Farm, PartsAreTheWhole) {
    expect_done({});
    std::vector<std::string> whole;
    for (int i = 0; i < 6; ++i) whole.push_back(folder_.read("out/" + std::to_string(i) + ".png"));
    EXPECT_NE(whole[0], whole[1]);
    for (int i = 0; i < 6; ++i) folder_.write("out/" + std::to_string(i) + ".png", "");
    expect_done({"--part", "2/4"});
    for (int i = 0; i < 6; ++i) EXPECT_EQ(folder_.read("out/" + std::to_string(i) + ".png").empty(), i % 4 != 1) << i;
    for (const char* part : {"1/4", "3/4", "4/4"}) expect_done({"--part", part});
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(folder_.read("out/" + std::to_string(i) + ".png"), whole[i]);
    // Two parts may not write one file either.
    EXPECT_TRUE(fails(render(folder_, {"a.xyz", "--frames", "all,0", "-o", "out/{frame}", "--part", "2/7"}), 2,
                      "out/0.png: cannot be both the picture of a.xyz, 0 and the picture of a.xyz, 0; frame 0 is named twice"));
    EXPECT_EQ(render(folder_, {"a.xyz", "--frames", "all", "-s", "9x9", "-o", "/dev/null", "--part", "1/2"}).status, 0);
    for (const char* wrong : {"0/4", "5/4", "1", "1/", "/4", "-1/4", "1/0"}) EXPECT_EQ(farm({"--part", wrong}).status, 2) << wrong;
}

// What the first frame gives no radius for, no range or no scale, another frame does: the same one in every part.
TEST_F(Farm, PartsShareWhatTheFirstFrameThatHasItGives) {
    const std::string points = "Properties=pos:R:3\n";
    const std::string words = "Properties=species:S:1:pos:R:3:v:S:1\nH 0 0 0 low\nH 3 0 0 high\n";
    const std::string numbers = "2\nProperties=species:S:1:pos:R:3:v:R:1\n";
    const auto radius =
        "1\n" + points + "0 0 0\n1\n" + points + "1 0 0\n2\n" + points + "0 0 0\n4 0 0\n2\n" + points + "0 0 0\n9 0 0\n";
    const auto values = numbers + "H 0 0 0 1\nH 3 0 0 5\n" + numbers + "H 0 0 0 2\nH 3 0 0 9\n";
    struct {
        std::string file;
        std::vector<std::string> look;
    } const files[] = {
        {radius, {}},
        {radius, {"--color-by", "radius"}},
        {"2\n" + words + values, {"--color-by", "v"}},
        {numbers + "H 0 0 0 0\nH 3 0 0 -1\n" + values, {"--size-by", "v"}},
        {"2\n" + words + "1\nProperties=species:S:1:pos:R:3:v:S:1\nH 3 0 0 high\n2\n" + words + values, {"--color-by", "v"}},
    };
    folder_.write("camera.toml", "[camera]\neye = [2, 0, 6]\ncenter = [2, 0, 2]\nright = [2, 0, 0]\nup = [0, 2, 0]\n");
    for (const auto& [file, look] : files) {
        folder_.write("a.xyz", file);
        for (const auto& camera : {std::vector<std::string>{"--camera", "camera.toml"}, {}}) {
            const std::vector<std::string> options = all_words(look, camera);
            expect_done(all_words(options, {"--manifest", "whole.jsonl"}));
            std::string parts;
            for (const char* part : {"3/3", "2/3", "1/3"}) {
                expect_done(all_words(options, {"--part", part, "--manifest", "made.jsonl"}));
                parts += folder_.read("made.jsonl");
            }
            std::vector<std::string> made = test::lines(parts);
            std::vector<std::string> whole = test::lines(folder_.read("whole.jsonl"));
            std::ranges::sort(made);
            std::ranges::sort(whole);
            EXPECT_EQ(made, whole);
            EXPECT_EQ(verify().status, 0);
            const Outcome more = farm(all_words(options, {"--skip-existing", "--manifest", "whole.jsonl", "--verbose"}));
            EXPECT_TRUE(contains(
                more.errors, std::to_string(whole.size()) + " of " + std::to_string(whole.size()) + " pictures are there already"))
                << more;
        }
    }
}

TEST_F(Farm, WhatIsThereWholeIsLeftAlone) {
    expect_done({});
    const std::string good = folder_.read("out/1.png");
    folder_.write("out/0.png", good);                             // whole, of the wanted size: left as it is
    folder_.write("out/1.png", good.substr(0, good.size() - 1));  // cut off
    folder_.write("out/2.png", "");
    folder_.write("out/3.png", "no picture, but longer than the head of one has to be");
    folder_.write("out/4.png", encode_png(plain_picture(20, 15, {1, 2, 3})));
    const std::string plain = encode_png(plain_picture(20, 16, {1, 2, 3}));
    folder_.write("out/5.png", plain);
    const Outcome outcome = farm({"--skip-existing", "--verbose"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "2 of 6 pictures are there already\n")) << outcome;
    EXPECT_EQ(folder_.read("out/0.png"), good);
    EXPECT_EQ(folder_.read("out/1.png"), good);
    EXPECT_EQ(folder_.read("out/5.png"), plain);
    for (const char* name : {"out/2.png", "out/3.png", "out/4.png"}) EXPECT_EQ(decode_png(folder_.read(name)).height, 16);
    EXPECT_EQ(farm({"--skip-existing", "--expect", "out/{frame}.png"}).status, 2);
}

TEST_F(Farm, AManifestGoesOnWhereItWasCutOff) {
    expect_done({"--manifest", "made.jsonl", "--turntable", "12"});
    const std::string text = folder_.read("made.jsonl");
    std::size_t third = 0;
    for (int i = 0; i < 3; ++i) third = text.find('\n', third) + 1;
    folder_.write("made.jsonl", text.substr(0, third + 40));
    const Outcome cut = verify();
    EXPECT_EQ(cut.output, "3 of 3 pictures rendered again: all are equal\n");
    EXPECT_EQ(cut.errors,
              "made.jsonl:4:1: the line is cut off: its picture is not looked at\n"
              "3 of 6 pictures have no line: a.xyz, 3; a.xyz, 4; a.xyz, 5\n");
    // The pictures are all there, but of three it is not known what they are of.
    const Outcome outcome = farm({"--manifest", "made.jsonl", "--turntable", "12", "--skip-existing", "--verbose"});
    EXPECT_TRUE(contains(outcome.errors, "3 of 6 pictures are there already\n")) << outcome;
    EXPECT_EQ(folder_.read("made.jsonl"), text);
    EXPECT_EQ(verify().status, 0);
}

// A picture that is damaged or gone is made once more, and has one line.
TEST_F(Farm, AManifestHasOneLineForAPictureThatIsMadeAgain) {
    expect_done({"--manifest", "made.jsonl"});
    std::vector<std::string> made = test::lines(folder_.read("made.jsonl"));
    std::filesystem::remove(folder_.path("out/1.png"));
    folder_.write("out/3.png", folder_.read("out/3.png").substr(0, 50));
    const Outcome again = farm({"--manifest", "made.jsonl", "--skip-existing", "--verbose"});
    EXPECT_TRUE(contains(again.errors, "4 of 6 pictures are there already\n") && !contains(again.errors, "made.jsonl")) << again;
    std::vector<std::string> now = test::lines(folder_.read("made.jsonl"));
    std::ranges::sort(made);
    std::ranges::sort(now);
    EXPECT_EQ(now, made);
    EXPECT_EQ(verify().output, "6 of 6 pictures rendered again: all are equal\n");
    // Of lines that are there twice one stays, and it is of one picture wherever they are.
    const std::string text = folder_.read("made.jsonl");
    folder_.write("made.jsonl", text + text);
    EXPECT_EQ(verify({"made.jsonl"}).output, "6 of 6 pictures rendered again: all are equal\n");
    expect_done({"--manifest", "made.jsonl", "--skip-existing"});
    EXPECT_EQ(folder_.read("made.jsonl"), text);
    // The last one, as of a file that another release has packed.
    std::string packed_anew = test::lines(text).front();
    const std::string by = "\"version\":\"";
    packed_anew.replace(packed_anew.find(by), by.size(), by + "9");
    folder_.write("made.jsonl", text + packed_anew + "\n");
    expect_done({"--manifest", "made.jsonl", "--skip-existing"});
    EXPECT_EQ(folder_.read("made.jsonl"), packed_anew + text.substr(text.find('\n')));
}

TEST_F(Farm, AManifestKeepsTheLineOfAPictureThatCannotBeMadeAgain) {
    expect_done({"--manifest", "made.jsonl"});
    const std::string text = folder_.read("made.jsonl");
    std::filesystem::remove(folder_.path("out/1.png"));
    folder_.write("out/1.png/file", "");
    EXPECT_EQ(farm({"--manifest", "made.jsonl", "--skip-existing"}).status, 4);
    EXPECT_EQ(folder_.read("made.jsonl"), text);
}

// As make does: what was made of something else is made anew, and the rest stays.
TEST_F(Farm, WhatWasMadeOfSomethingElseIsMadeAnew) {
    const std::string other_line = [] {
        std::string line = R"({"frame":0,"picture":"other.png","place":0,"scene":"b.xyz","scene_sha256":"1","camera_sha256":null,)";
        return line + R"("options":[],"pixels_sha256":"2","file_sha256":"3","version":"1"})" + "\n";
    }();
    folder_.write("made.jsonl", other_line);
    expect_done({"--manifest", "made.jsonl", "--skip-existing"});
    const std::string first = folder_.read("made.jsonl");
    EXPECT_TRUE(first.starts_with(other_line)) << first;
    const std::string picture = folder_.read("out/3.png");
    const auto expect_anew = [&](const std::vector<std::string>& more, const std::string& what) {
        std::vector<std::string> arguments = {"--manifest", "made.jsonl", "--skip-existing"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = farm(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.errors, what.empty() ? ""
                                               : "made.jsonl: " + what + " made of another file or with other options " +
                                                     (what.starts_with("1 ") ? "is" : "are") + " rendered anew\n");
        EXPECT_EQ(lines().size(), 7U);
    };
    expect_anew({}, "");
    EXPECT_EQ(folder_.read("made.jsonl"), first);
    const std::string differ = " pictures that were";
    expect_anew({"--view", "30,20", "--part", "2/2"}, "3" + differ);
    EXPECT_NE(folder_.read("out/3.png"), picture);
    expect_anew({}, "3" + differ);
    EXPECT_EQ(folder_.read("out/3.png"), picture);
    expect_anew({"--view", "30,20", "--part", "2/6"}, "1 picture that was");
    expect_anew({}, "1 picture that was");
    folder_.write("a.xyz", folder_.read("a.xyz") + "\n");
    expect_anew({}, "6" + differ);
}

// Of a longer list of frames only those are made anew that it changes.
TEST_F(Farm, ALongerListLeavesThePicturesThatItDoesNotChange) {
    folder_.write("camera.toml", "[camera]\neye = [0, 0, -9]\ncenter = [0, 0, -8]\nright = [1, 0, 0]\nup = [0, 1, 0]\n");
    const auto rendered = [&](const std::string& frames, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"a.xyz",          "--frames",  frames,        "-s",
                                              "20x16",          "-o",        "out/{frame}", "--manifest",
                                              "out/made.jsonl", "--no-sync", "--verbose",   "--skip-existing"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = render(folder_, arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        return outcome.errors;
    };
    const auto begun_anew = [&] { folder_.write("out/made.jsonl", ""); };
    const std::string changed = "out/made.jsonl: ";
    for (const std::vector<std::string>& camera :
         std::vector<std::vector<std::string>>{{"--fit", "first"}, {"--camera", "camera.toml"}, {"--no-fit"}}) {
        begun_anew();
        EXPECT_TRUE(contains(rendered("0:2", camera), "0 of 2 pictures are there already\n"));
        const std::string longer = rendered("0:5", camera);
        EXPECT_TRUE(contains(longer, "2 of 5 pictures are there already\n") && !contains(longer, changed)) << longer;
        EXPECT_TRUE(contains(rendered(camera.front() == "--fit" ? "0,3" : "3,1", camera), "2 of 2 pictures are there already\n"));
        const Outcome all = sphereview({"verify", "out/made.jsonl", "--backend", "cpu"});
        EXPECT_EQ(all.output, "5 of 5 pictures rendered again: all are equal\n") << all;
        EXPECT_FALSE(all.errors.find(" pictures ") != std::string::npos) << all;
    }
    // The fitted camera sees more, and colours have another range.
    begun_anew();
    rendered("0:2", {});
    EXPECT_TRUE(contains(rendered("0:5", {}), changed + "2 pictures"));
    const std::vector<std::string> by_range = {"--camera", "camera.toml", "--color-by", "x"};
    begun_anew();
    rendered("1:3", by_range);
    EXPECT_TRUE(contains(rendered("0:3", by_range), changed + "2 pictures"));
    // The same number and place, but another frame, or the same frame from another side.
    const std::vector<std::string> turned = {"--camera", "camera.toml", "--turntable", "4"};
    begun_anew();
    rendered("0", turned);
    EXPECT_TRUE(contains(rendered("0:4", turned), changed + "3 pictures"));
    EXPECT_TRUE(contains(rendered("0:4", {"--camera", "camera.toml", "--turntable", "8"}), changed + "3 pictures"));
}

}  // namespace
}  // namespace sphereview::test

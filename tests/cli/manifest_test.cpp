// What a manifest says of pictures, and what proves it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "cli/fails.hpp"
#include "cli/farm.hpp"
#include "support/eventually.hpp"
#include "support/folders.hpp"
#include "support/sha256.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// Of all six pictures, and that they are not looked at.
void expect_said(const Outcome& outcome, const std::string& fault) {
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(outcome.errors.starts_with(fault + "\n")) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "6 of 6 pictures cannot be rendered again: ")) << outcome;
    EXPECT_EQ(outcome.output, "0 of 6 pictures rendered again: not all are equal\n");
}

TEST_F(Farm, AManifestSaysWhatPicturesAreMadeOf) {
    expect_done({"--manifest", "made.jsonl", "--view", "30,20"});
    const std::vector<Json> made = lines();
    ASSERT_EQ(made.size(), 6U);
    const std::string png = folder_.read("out/3.png");
    EXPECT_EQ(made[3]["frame"], 3);
    EXPECT_EQ(made[3]["picture"], "out/3.png");
    EXPECT_EQ(made[3]["scene"], "a.xyz");
    EXPECT_EQ(made[3]["scene_sha256"], sha256(folder_.read("a.xyz")));
    EXPECT_EQ(made[3]["file_sha256"], sha256(png));
    EXPECT_EQ(made[3]["pixels_sha256"], sha256(decode_png(png).bytes));
    EXPECT_EQ(made[3]["options"], Json::parse(R"(["--size", "20x16", "--view", "30,20", "--frames", "all"])"));

    const Outcome equal = verify();
    EXPECT_EQ(equal.status, 0) << equal;
    EXPECT_EQ(equal.output, "6 of 6 pictures rendered again: all are equal\n");
    EXPECT_EQ(verify({"--sample", "1%"}).output, "1 of 6 pictures rendered again: all are equal\n");
    EXPECT_EQ(verify({"--sample", "4"}).output, "4 of 6 pictures rendered again: all are equal\n");

    // A picture that is another one now.
    folder_.write("out/3.png", png + "x");
    const Outcome changed = verify();
    EXPECT_EQ(changed.status, 1) << changed;
    EXPECT_EQ(changed.errors, "out/3.png: the file differs from the one that was written\n");
    folder_.write("out/3.png", png);
    // A line that is not true.
    std::string text = folder_.read("made.jsonl");
    const std::string sum = made[2]["pixels_sha256"];
    text.replace(text.find(sum), sum.size(), std::string(64, '0'));
    folder_.write("made.jsonl", text);
    const Outcome differs = verify();
    EXPECT_EQ(differs.status, 1) << differs;
    EXPECT_TRUE(contains(differs.errors, "out/2.png: differs: the SHA-256 of its pixels is " + sum)) << differs;
    // A picture of another frame than its place says.
    const std::string place = "\"frame\":4";
    ASSERT_TRUE(contains(text, place)) << text;
    std::string moved = text;
    folder_.write("made.jsonl", moved.replace(moved.find(place), place.size(), "\"frame\":5"));
    const Outcome other = verify();
    EXPECT_EQ(other.status, 2) << other;
    const std::string said = "a.xyz: found picture 4 with the number 5 in a manifest, expected 4";
    EXPECT_TRUE(contains(other.errors, said)) << other;
    // Nor does a true line hide it, wherever it stands.
    for (const std::string& both : {moved + text, text + moved}) {
        folder_.write("made.jsonl", both);
        EXPECT_TRUE(contains(verify().errors, said)) << both;
    }
    // Another scene.
    folder_.write("made.jsonl", text);
    folder_.write("a.xyz", folder_.read("a.xyz") + "\n");
    EXPECT_EQ(verify().status, 2);
}

TEST_F(Farm, APartWithoutPicturesKeepsNoLineOfTheFileAsItWas) {
    expect_done({"--part", "6/6", "--manifest", "made.jsonl"});
    EXPECT_FALSE(folder_.read("made.jsonl").empty());
    folder_.write("a.xyz", moving_atom(3));
    expect_done({"--part", "6/6", "--manifest", "made.jsonl", "--skip-existing"});
    EXPECT_EQ(folder_.read("made.jsonl"), "");
}

TEST_F(Farm, AManifestFromBeforeAChangeOfTheSceneIsOfAnotherFile) {
    expect_done({"--manifest", "old.jsonl"});
    const std::string old = sha256(folder_.read("a.xyz"));
    folder_.write("a.xyz", folder_.read("a.xyz") + "\n");
    expect_done({"--manifest", "made.jsonl"});
    const std::string now = sha256(folder_.read("a.xyz"));
    const std::string said =
        "a.xyz: found another file than the pictures were made of: its SHA-256 is " + now + ", expected " + old;
    const std::string unfit =
        " pictures cannot be rendered again: out/0.png; out/1.png; out/2.png; out/3.png; out/4.png; out/5.png\n";
    // Whatever the sample, it is said of all; the others are rendered.
    const Outcome both = verify({"old.jsonl", "--sample", "1"});
    EXPECT_EQ(both.status, 2) << both;
    EXPECT_EQ(both.errors, said + "\n6 of 12" + unfit);
    EXPECT_EQ(both.output, "1 of 12 pictures rendered again: not all are equal\n");
    // No picture is made anew that has a line of the file as it is.
    folder_.write("made.jsonl", folder_.read("old.jsonl") + folder_.read("made.jsonl"));
    EXPECT_EQ(farm({"--manifest", "made.jsonl", "--skip-existing", "--verbose"}).errors, "6 of 6 pictures are there already\n");
    EXPECT_EQ(verify().output, "6 of 6 pictures rendered again: all are equal\n");
    // Nor is there a line of a frame that the file no longer has.
    folder_.write("a.xyz",
                  folder_.read("a.xyz").substr(0, folder_.read("a.xyz").find("H 4") - std::string("2\n\nO 0 0 0\n").size()));
    expect_done({"--manifest", "made.jsonl", "--skip-existing"});
    EXPECT_EQ(lines().size(), 3U);
}

TEST_F(Farm, AManifestIsVerifiedWhateverElseIsWrong) {
    for (const char* name : {"b.xyz", "c.xyz"}) std::filesystem::copy_file(folder_.path("a.xyz"), folder_.path(name));
    const Outcome made = render(folder_, {"a.xyz", "b.xyz", "c.xyz", "--frames", "all", "-s", "20x16", "-o", "out/{name}{frame}",
                                          "--no-sync", "--manifest", "made.jsonl"});
    ASSERT_EQ(made.status, 0) << made;
    std::filesystem::remove(folder_.path("a.xyz"));
    std::string text = folder_.read("made.jsonl");
    const auto change = [&](const std::string& old, const std::string& changed) {
        const std::size_t at = text.find(old, text.find("\"b.xyz\""));
        ASSERT_NE(at, std::string::npos);
        text.replace(at, old.size(), changed);
    };
    change("[\"--size\"", "[\"--json\",\"--size\"");
    change("\"frame\":4", "\"frame\":5");
    folder_.write("made.jsonl", text);
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.output, "10 of 18 pictures rendered again: not all are equal\n");
    const std::vector<std::string> said = test::lines(outcome.errors);
    ASSERT_EQ(said.size(), 5U) << outcome;
    EXPECT_TRUE(said[0].starts_with("a.xyz: ")) << outcome;
    EXPECT_EQ(said[1], "made.jsonl:7:1: found '--json', expected options that say what a picture looks like");
    EXPECT_EQ(said[2], "made.jsonl:11:1: b.xyz: found picture 4 with the number 5 in a manifest, expected 4");
    EXPECT_TRUE(said[3].starts_with("7 of 18 pictures cannot be rendered again: out/a0.png; ")) << outcome;
    EXPECT_EQ(said[4], "2 of 6 pictures have no line: b.xyz, 0; b.xyz, 4");
}

// The fourth picture waits in a pipe while the scene becomes another one.
TEST_F(Farm, AManifestEndsWhereItsSceneChanges) {
    ASSERT_TRUE(std::filesystem::create_directory(folder_.path("out")));
    ASSERT_EQ(mkfifo(folder_.path("out/3.png").c_str(), 0600), 0);
    Running program(cpu_render(
        folder_, {"a.xyz", "--frames", "all", "-s", "20x16", "-o", "out/{frame}.png", "--no-sync", "--manifest", "made.jsonl"}));
    ASSERT_TRUE(eventually([&] {
        const std::string text = folder_.has("made.jsonl") ? folder_.read("made.jsonl") : "";
        return std::ranges::count(text, '\n') == 3;
    }));
    folder_.write("a.xyz", folder_.read("a.xyz") + "\n");
    folder_.read("out/3.png");
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_EQ(outcome.errors,
              "a.xyz: has changed since the run began, expected the same file to the end: no further picture has a line\n"
              "sphereview: ended where a scene had changed; 3 of 6 pictures were done\n");
    EXPECT_EQ(lines().size(), 3U);
    EXPECT_FALSE(folder_.has("out/4.png"));
}

// Until its sum is made, too: here the camera is waited for, after the scene was opened.
TEST_F(Farm, AManifestHasNoSumOfAFileThatHasChangedSinceItWasOpened) {
    expect_done({"--manifest", "made.jsonl"});
    const std::string before = folder_.read("made.jsonl");
    ASSERT_EQ(mkfifo(folder_.path("camera.toml").c_str(), 0600), 0);
    Running program(cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "20x16", "-o", "out/{frame}.png", "--skip-existing",
                                         "--manifest", "made.jsonl", "--camera", "camera.toml"}));
    {
        std::ofstream pipe(folder_.path("camera.toml"));  // waits until it is opened to be read
        folder_.write("a.xyz", folder_.read("a.xyz") + "\n");
        folder_.write("file.toml", "background = 'white'\n");
        std::filesystem::rename(folder_.path("file.toml"), folder_.path("camera.toml"));
        pipe << "background = 'white'\n";
    }
    EXPECT_TRUE(fails(program.wait(), 2, "a.xyz: has changed since the run began, expected the same file to the end"));
    EXPECT_EQ(folder_.read("made.jsonl"), before);
}

TEST_F(Farm, AManifestLeavesOutAWrongScene) {
    folder_.write("b.xyz", "1\n\nH 0 0 0\n");
    folder_.write("empty.xyz", "");
    ASSERT_EQ(mkfifo(folder_.path("fifo.xyz").c_str(), 0600), 0);
    for (const auto& frames : {std::vector<std::string>{}, {"--frames", "all"}}) {
        folder_.write("made.jsonl", "");
        for (const char* ending : {"", "--skip-existing"}) {
            std::vector<std::string> words = {"gone.xyz",   "fifo.xyz",  "empty.xyz", "b.xyz",
                                              "-s",         "20x16",     "-o",        "one/{name}-{frame}.png",
                                              "--manifest", "made.jsonl"};
            if (*ending != 0) words.emplace_back(ending);
            const Outcome outcome = render(folder_, all_words(words, frames));
            EXPECT_EQ(outcome.status, 2) << outcome;
            EXPECT_TRUE(contains(outcome.errors, "gone.xyz: ")) << outcome;
            EXPECT_TRUE(contains(outcome.errors, "fifo.xyz: found no regular file")) << outcome;
            EXPECT_TRUE(contains(outcome.errors, "empty.xyz:")) << outcome;
            EXPECT_FALSE(contains(outcome.errors, "empty.xyz: found no regular file")) << outcome;
            EXPECT_EQ(lines().size(), 1U);
            EXPECT_TRUE(folder_.has("one/b-0.png"));
        }
        EXPECT_EQ(verify().status, 0);
    }
    // A file without a byte is one all the same.
    folder_.write("one/b-0.png", "");
    EXPECT_TRUE(fails(verify(), 1, "one/b-0.png: the file differs from the one that was written"));
}

// JSON holds no other names.
TEST_F(Farm, AManifestHasNamesInUtf8) {
    std::filesystem::copy_file(folder_.path("a.xyz"), folder_.path("b\xff.xyz"));
    const std::vector<std::string> arguments = {"b\xff.xyz",       "--frames",   "all",       "-o",
                                                "out/{frame}.png", "--manifest", "made.jsonl"};
    EXPECT_TRUE(fails(render(folder_, arguments), 2, "sphereview: --manifest: found 'b\\xff.xyz', expected a name in UTF-8"));
    EXPECT_FALSE(folder_.has("made.jsonl") || folder_.has("out"));
}

// Of few frames some part has none.
TEST_F(Farm, AManifestMayBeWithoutALine) {
    expect_done({"--part", "7/7", "--manifest", "none.jsonl"});
    expect_done({"--manifest", "made.jsonl"});
    EXPECT_EQ(verify({"none.jsonl"}).output, "6 of 6 pictures rendered again: all are equal\n");
    EXPECT_TRUE(fails(sphereview({"verify", "none.jsonl"}), 2, "none.jsonl: found no whole line, expected one for each picture"));
}

// It says where it is broken, and of a picture that is no file the others are looked at.
TEST_F(Farm, AManifestIsReadLineByLine) {
    expect_done({"--manifest", "made.jsonl"});
    const std::string text = folder_.read("made.jsonl");
    const std::size_t second = text.find('\n') + 1;
    folder_.write("made.jsonl", text.substr(0, second) + "\n \n" + text.substr(second) + "{");
    const Outcome cut = verify();
    EXPECT_EQ(cut.output, "6 of 6 pictures rendered again: all are equal\n");
    EXPECT_EQ(cut.errors, "made.jsonl:9:1: the line is cut off: its picture is not looked at\n");
    folder_.write("made.jsonl", text.substr(0, second) + "{]\n" + text.substr(second));
    EXPECT_TRUE(fails(verify(), 2, "made.jsonl:2:2: this is not JSON"));
    std::string with_nul = text;
    with_nul.replace(with_nul.find("out/0.png"), 5, "out\\u0000/0");
    folder_.write("made.jsonl", with_nul);
    EXPECT_TRUE(fails(verify(), 2, "made.jsonl:1:1: found a NUL in 'picture', expected a text without one"));
    std::string by_another = text;
    const std::string by = "\"version\":\"";
    by_another.replace(by_another.rfind(by), by.size(), by + "9");
    folder_.write("made.jsonl", by_another);
    EXPECT_TRUE(contains(verify().errors, "made.jsonl: there are pictures by sphereview 9")) << by_another;

    folder_.write("made.jsonl", text);
    std::filesystem::remove(folder_.path("out/1.png"));
    std::filesystem::create_directory(folder_.path("out/1.png"));
    folder_.write("out/2.png", "another");
    std::filesystem::remove(folder_.path("out/3.png"));
    ASSERT_EQ(mkfifo(folder_.path("out/3.png").c_str(), 0600), 0);
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "out/1.png: found no regular file")) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "out/3.png: found no regular file")) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "out/2.png: the file differs from the one that was written\n")) << outcome;
}

// It may lie where the pictures will be. Of a line that lacks its place nobody is accused.
TEST_F(Farm, AManifestHasItsFolderAndWholeLines) {
    EXPECT_EQ(farm({"--manifest", "-"}).status, 2);
    EXPECT_FALSE(folder_.has("-"));
    expect_done({"--manifest", "out/made.jsonl"});
    std::string text = folder_.read("out/made.jsonl");
    const std::string place = "\"place\":3,";
    ASSERT_NE(text.find(place), std::string::npos);
    text.replace(text.find(place), place.size(), "");
    folder_.write("made.jsonl", text);
    EXPECT_TRUE(fails(verify(), 2, "made.jsonl:4:1: found no 'place' from 0, expected a line of a manifest"));
    // Nor is it JSON.
    text = folder_.read("out/made.jsonl");
    const std::size_t fault = text.find(place);
    folder_.write("made.jsonl", text.replace(fault, place.size(), "}"));
    EXPECT_TRUE(fails(verify(), 2, "made.jsonl:4:" + std::to_string(fault - text.rfind('\n', fault)) + ": this is not JSON"));
    // Nor is a device read to an end that it has not.
    text = folder_.read("out/made.jsonl");
    for (std::size_t at = 0; (at = text.find("\"a.xyz\"", at)) != std::string::npos;) text.replace(at, 7, "\"/dev/zero\"");
    folder_.write("made.jsonl", text);
    expect_said(verify(), "/dev/zero: found no regular file, expected one: a device may have no end");
}

// Somebody else may have made it.
TEST_F(Farm, AManifestCannotMakeVerifyWaitOrDoSomethingElse) {
    folder_.write("c.toml", "background = 'white'\n");
    ASSERT_EQ(mkfifo(folder_.path("fifo").c_str(), 0600), 0);
    expect_done({"--manifest", "made.jsonl", "--camera", "c.toml"});
    EXPECT_EQ(verify().status, 0);
    const std::string text = folder_.read("made.jsonl");
    const auto expect_refused = [&](const std::string& old, const std::string& changed, const std::string& said) {
        std::string other = text;
        ASSERT_TRUE(contains(other, old)) << other;
        for (std::size_t at = 0; (at = other.find(old, at)) != std::string::npos; at += changed.size()) {
            other.replace(at, old.size(), changed);
        }
        folder_.write("made.jsonl", other);
        expect_said(verify(), said);
    };
    const std::string no_file = "fifo: found no regular file, expected one: a device may have no end";
    expect_refused("\"c.toml\"", "\"fifo\"", no_file);
    expect_refused("\"a.xyz\"", "\"fifo\"", no_file);
    expect_refused("\"" + sha256(folder_.read("c.toml")) + "\"", "null",
                   "made.jsonl:1:1: found '--camera', expected 'camera_sha256' with it");
    for (const char* word : {"--help", "-h", "--output", "-o", "-ox", "--manifest", "--json", "--nothing", "SCENE", "--", "x"}) {
        expect_refused("[\"--size\"", std::string("[\"") + word + "\",\"--size\"",
                       std::string("made.jsonl:1:1: found '") + word + "', expected options that say what a picture looks like");
    }
}

// By strace, which cannot trace where that is forbidden.
TEST_F(Farm, AManifestIsOnTheDiskAsItsPicturesAre) {
    const auto synced = [&](const std::vector<std::string>& more) {
        Command command = cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "20x16", "-o", "out/{frame}.png"});
        command.arguments.insert(command.arguments.end(), more.begin(), more.end());
        const std::vector<std::string> by = {
            "strace", "-D", "-f", "-qq", "-o", "trace", "-e", "trace=fsync", build_file("sphereview")};
        command.program = "/usr/bin/env";
        command.arguments.insert(command.arguments.begin(), by.begin(), by.end());
        command.environment.emplace_back("LSAN_OPTIONS", "detect_leaks=0");  // it, too, would want to trace the program
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
        const std::string trace = folder_.read("trace");
        std::size_t calls = 0;
        for (std::size_t at = 0; (at = trace.find("fsync(", at)) != std::string::npos; ++at) ++calls;
        return calls;
    };
    Command traced;
    traced.program = "/usr/bin/env";
    traced.arguments = {"strace", "-D", "-o", "/dev/null", "true"};
    if (run(traced).status != 0) GTEST_SKIP() << "strace does not work here";
    folder_.write("out/other.png", "");  // the folder is not made
    const std::size_t pictures = synced({});
    const std::size_t begin = synced({"--no-sync", "--manifest", "made.jsonl"});  // of the empty manifest
    EXPECT_EQ(synced({"--manifest", "made.jsonl"}), pictures + begin + 6);
}

TEST_F(Farm, VerifySaysWhatIsMissing) {
    expect_done({"--manifest", "made.jsonl"});
    std::filesystem::remove(folder_.path("out/2.png"));
    const Outcome gone = verify();
    EXPECT_EQ(gone.status, 0) << gone;
    EXPECT_EQ(gone.errors, "1 of 6 pictures is not here: out/2.png\n");
    expect_done({"--manifest", "made.jsonl", "--part", "1/3"});
    EXPECT_EQ(verify().errors, "4 of 6 pictures have no line: a.xyz, 1; a.xyz, 2; a.xyz, 4; a.xyz, 5\n");
    expect_done({"--manifest", "others.jsonl", "--part", "2/3"});
    EXPECT_EQ(verify({"others.jsonl"}).errors, "2 of 6 pictures have no line: a.xyz, 2; a.xyz, 5\n");
    // Once, whatever the lists of frames.
    folder_.write("camera.toml", "[camera]\neye = [0, 0, -9]\ncenter = [0, 0, -8]\nright = [1, 0, 0]\nup = [0, 1, 0]\n");
    expect_done({"--manifest", "made.jsonl", "--camera", "camera.toml", "--part", "1/2"});
    const Outcome some = render(folder_, {"a.xyz", "--frames", "0:4", "-s", "20x16", "-o", "out/{frame}.png", "--camera",
                                          "camera.toml", "--part", "1/2", "--manifest", "others.jsonl"});
    EXPECT_EQ(some.status, 0) << some;
    EXPECT_EQ(verify({"others.jsonl"}).errors, "3 of 6 pictures have no line: a.xyz, 1; a.xyz, 3; a.xyz, 5\n");
}

}  // namespace
}  // namespace sphereview::test

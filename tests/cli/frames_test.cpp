// Pictures of several frames, and around a scene.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "cli/frames.hpp"
#include "support/eventually.hpp"
#include "support/json.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

// An oxygen in the middle of two hydrogens that go away.
constexpr const char* breathing = "3\n0\nH -1 0 0\nH 1 0 0\nO 0 0 0\n3\n1\nH -6 0 0\nH 6 0 0\nO 0 0 0\n";

// Pixels of the oxygen's colour.
int red_pixels(const Picture& shown) {
    int count = 0;
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) count += shown.at(x, y) == std::vector<int>{255, 13, 13} ? 1 : 0;
    }
    return count;
}

TEST_F(Frames, HaveOneCamera) {
    folder_.write("breathing.xyz", breathing);
    expect_done({"breathing.xyz", "--frames", "all", "-s", "100x100", "-o", "out/{name}-{frame:05}.png"});
    const int first = red_pixels(picture("out/breathing-00000.png"));
    EXPECT_GT(first, 20);
    EXPECT_EQ(first, red_pixels(picture("out/breathing-00001.png")));
    // The union of what they hold is what the second holds.
    expect_done({"breathing.xyz", "--frame", "1", "-s", "100x100", "-o", "alone"});
    EXPECT_EQ(picture("alone.png"), picture("out/breathing-00001.png"));
    expect_done({"breathing.xyz", "--frame", "0", "-s", "100x100", "-o", "alone"});
    EXPECT_GT(red_pixels(picture("alone.png")), 5 * first);

    // Fitted to the first frame, the second's hydrogens are beside the picture.
    expect_done({"--fit", "first", "breathing.xyz", "--frames", ":", "-s", "100x100"});
    EXPECT_EQ(picture("breathing-00000.png"), picture("alone.png"));
    EXPECT_EQ(red_pixels(picture("breathing-00001.png")), red_pixels(picture("breathing-00000.png")));
}

// The camera of the first frame need not see the others.
TEST_F(Frames, SayThatNoPixelShowsASphere) {
    folder_.write("a.xyz", "1\n\nH 0 0 0\n1\n\nH 900 900 900\n");
    EXPECT_EQ(render({"a.xyz", "--frames", "all", "-s", "9x9", "--fit", "first"}).errors,
              "a.xyz, 1: no pixel shows a sphere; --fit frames all\n");
}

// By the first frame's range and scale: made of each frame's own values, colours and sizes would come and go.
TEST_F(Frames, HaveOneRangeOfColoursAndSizes) {
    const auto frame = [](const char* first, const char* second) {
        return std::string("2\nProperties=species:S:1:pos:R:3:v:R:1\nH -1 0 0 ") + first + "\nH 1 0 0 " + second + "\n";
    };
    folder_.write("v.xyz", frame("1", "2") + frame("1.5", "3"));
    folder_.write("camera.toml", "[camera]\neye = [0, 0, 10]\ncenter = [0, 0, 9]\nright = [-0.3, 0, 0]\nup = [0, 0.3, 0]\n");
    const auto rendered = [&](std::vector<std::string> more) {
        for (const char* word : {"v.xyz", "-s", "50x50", "--camera", "camera.toml", "--color-by", "v", "--size-by", "v"})
            more.emplace_back(word);
        const Outcome outcome = render(more);
        EXPECT_EQ(outcome.status, 0) << outcome;
        return outcome.errors;
    };
    const std::string said = "v.xyz: colours by v: viridis from 1 to 2\nv.xyz: radii by v: 0.5 times the value\n";
    const std::string beyond = " values beyond 1 to 2, the first frame's range; --range gives another\n";
    EXPECT_EQ(rendered({"--frames", "all"}), said + "v.xyz: frame 1 holds" + beyond);
    rendered({"--frame", "1", "-o", "alone", "--range", "1:2", "--scale", "0.5"});
    EXPECT_EQ(picture("v-00001.png"), picture("alone.png"));
    rendered({"--frame", "1", "-o", "alone"});
    EXPECT_NE(picture("v-00001.png"), picture("alone.png"));

    folder_.write("v.xyz", frame("1", "2") + frame("1.5", "2") + frame("0.5", "1") + frame("1", "1") + frame("1", "3"));
    EXPECT_EQ(rendered({"--frames", "all"}), said + "v.xyz: frame 2 and another hold" + beyond);
    EXPECT_FALSE(contains(rendered({"--frames", "all", "--range", "1:2"}), "beyond"));
    EXPECT_FALSE(contains(rendered({"--frames", "all", "--part", "2/2"}), "beyond"));
    folder_.write("v.xyz", frame("1", "2") + frame("0.5", "9") + frame("0.5", "1") + frame("1", "3"));
    EXPECT_EQ(rendered({"--frames", "all", "--part", "2/2"}), said + "v.xyz: frame 1 and another hold" + beyond);
    EXPECT_EQ(rendered({"--frames", "all"}), said + "v.xyz: frame 1 and 2 others hold" + beyond);
}

TEST_F(Frames, HaveOneColourForACategory) {
    const auto frame = [](const std::string& left, const std::string& right) {
        return "2\nProperties=species:S:1:pos:R:3:v:S:1\nH -1 0 0 " + left + "\nH 1 0 0 " + right + "\n";
    };
    folder_.write("v.xyz", frame("a", "b") + frame("b", "c") + frame("c", "d") + frame("d", "b"));
    folder_.write("camera.toml", "[camera]\neye = [0, 0, 10]\ncenter = [0, 0, 9]\nright = [-0.3, 0, 0]\nup = [0, 0.3, 0]\n");
    const auto colors = [&](const std::vector<std::string>& more) {
        const Outcome outcome = render(all_words({"v.xyz", "-s", "60x60", "--camera", "camera.toml", "--color-by", "v"}, more));
        EXPECT_EQ(outcome.status, 0) << outcome;
        std::vector<std::vector<int>> found;
        for (const char* name : {"v-00000.png", "v-00001.png", "v-00002.png", "v-00003.png"}) {
            found.push_back(picture(name).at(40, 30));
            found.push_back(picture(name).at(20, 30));
        }
        return found;
    };
    const auto all = colors({"--frames", "all"});
    EXPECT_EQ(all[1], all[2]) << "b";
    EXPECT_EQ(all[3], all[4]) << "c";
    EXPECT_EQ(all[5], all[6]) << "d";
    EXPECT_EQ(all[1], all[7]) << "b";
    EXPECT_NE(all[3], all[0]);
    EXPECT_NE(all[3], all[1]);
    colors({"--frame", "0", "-o", "v-00000"});
    EXPECT_EQ(picture("v-00000.png").at(40, 30), all[0]) << "the first frame as by itself";
    for (const char* part : {"1/4", "2/4", "3/4", "4/4"}) EXPECT_EQ(colors({"--frames", "all", "--part", part}), all);
}

TEST_F(Frames, AreNamedByNumber) {
    folder_.write("a.xyz", moving_atom(5));
    expect_done({"a.xyz", "--frames", "1:5:2,-1", "-s", "9x9", "-o", "{frame}.png"});
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"1.png", "3.png", "4.png", "a.xyz"}));
    expect_done({"a.xyz", "--frames", "-2", "-s", "9x9"});
    EXPECT_TRUE(folder_.has("a-00003.png"));
    const Outcome json = render({"a.xyz", "--frames", ":2", "-s", "9x9", "--json"});
    EXPECT_TRUE(contains(json.output, "{\"scene\":\"a.xyz\",")) << json;
    EXPECT_TRUE(contains(json.output, "\"frame\":1")) << json;

    // What the scene's name itself holds is no placeholder.
    folder_.write("{frame}.xyz", moving_atom(5));
    expect_done({"{frame}.xyz", "--frames", "0", "-s", "9x9", "-o", "{name}-{frame}.png"});
    EXPECT_TRUE(folder_.has("{frame}-0.png"));

    const auto expect_fault = [&](const std::vector<std::string>& arguments, const std::string& fault) {
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.errors, fault + "\n");
    };
    expect_fault({"a.xyz", "--frames", "5"}, "a.xyz: found 5 frames, 0 to 4, expected frame 5");
    expect_fault(
        {"a.xyz", "--frames", "all", "-o", "a.png"},
        "a.png: cannot be both the picture of a.xyz, 1 and the picture of a.xyz, 0; use {frame} for each picture's number");
    expect_fault({"a.xyz", "--frames", "all,0", "-o", "{frame}.png"},
                 "0.png: cannot be both the picture of a.xyz, 0 and the picture of a.xyz, 0; frame 0 is named twice");
    expect_fault({"a.xyz", "--frames", "all", "-o", "{frame:5}"},
                 "sphereview: --output: found '{frame:5}', expected {frame}, or {frame:0N} with N from 1 to 18 for so many digits");
    EXPECT_EQ(render({"a.xyz", "--fit", "first"}).status, 2);
}

// A folder in the place of the second picture, which the third one would not meet: but disks that are full stay so.
TEST_F(Frames, EndWhereAPictureCannotBeWritten) {
    folder_.write("a.xyz", moving_atom(30));
    folder_.write("out/1.png/file", "");
    const std::string end = "\nsphereview: ended where a picture could not be written; 1 of 30 pictures were done\n";
    const Outcome outcome = render({"a.xyz", "--frames", "all", "-s", "9x9", "-o", "out/{frame}.png"});
    EXPECT_EQ(outcome.status, 4) << outcome;
    EXPECT_EQ(outcome.errors, "out/1.png: cannot be written: it is a folder" + end);
    EXPECT_TRUE(folder_.has("out/0.png"));
    EXPECT_FALSE(folder_.has("out/2.png"));
#ifdef __linux__
    const Outcome full = render({"a.xyz", "--frames", "all", "-s", "9x9", "--manifest", "/dev/full"});
    EXPECT_EQ(full.status, 4) << full;
    EXPECT_TRUE(contains(full.errors, "/dev/full: cannot be written: ")) << full;
    EXPECT_TRUE(contains(full.errors, "; 0 of 30 pictures were done\n")) << full;
#endif
}

TEST_F(Frames, SayOnceWhichRadiusAllPointsGet) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        text += "ITEM: TIMESTEP\n" + std::to_string(i) +
                "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\nITEM: ATOMS id type x y z\n1 1 0 0 0\n2 2 " +
                std::to_string(4 + i) + " 0 0\n";
    }
    folder_.write("d.lammpstrj", text);
    folder_.write("camera.toml", "[camera]\neye = [0, 0, 10]\ncenter = [0, 0, 9]\nright = [-1, 0, 0]\nup = [0, 1, 0]\n");
    const std::string said =
        "d.lammpstrj: no radius in the file: all get 1, a quarter of the median distance to the nearest neighbour; --radius gives "
        "another\n";
    for (const auto& more : {std::vector<std::string>{}, {"--camera", "camera.toml"}, {"--fit", "first"}}) {
        EXPECT_EQ(render(all_words({"d.lammpstrj", "--frames", "all", "-s", "20x20"}, more)).errors, said);
    }
}

TEST_F(Frames, TakeTheCameraOfAScene) {
    folder_.write("breathing.xyz", breathing);
    folder_.write(
        "view.toml",
        "[camera]\neye = [0, 0, -100]\n[[view]]\nname = \"near\"\neye = [0, 0, -20]\ncenter = [0, 0, -10]\nright = [5, 0, 0]\n"
        "up = [0, 5, 0]\n");
    expect_done({"breathing.xyz", "--frames", "all", "-s", "60x60", "--camera", "view.toml"});
    const int far = red_pixels(picture("breathing-00000.png"));
    expect_done({"breathing.xyz", "--frames", "all", "-s", "60x60", "--camera", "view.toml", "--view", "near"});
    EXPECT_GT(red_pixels(picture("breathing-00000.png")), far);
    expect_done({"breathing.xyz", "-s", "60x60", "--camera", "view.toml", "--view", "near", "-o", "still"});
    EXPECT_EQ(picture("still.png"), picture("breathing-00000.png"));
    EXPECT_EQ(render({"breathing.xyz", "--camera", "view.toml", "--view", "top"}).status, 2);
    EXPECT_EQ(render({"breathing.xyz", "--camera", "breathing.xyz"}).status, 2);
}

// A red sphere to the right of a blue one, seen from four sides.
TEST_F(Frames, GoRoundAScene) {
    folder_.write("two.txt", "2\n255 0 0\n10 0 200\n5\n0 0 250\n-10 0 200\n5\n");
    expect_done({"two.txt", "--turntable", "4", "-s", "41x41", "--fit"});
    EXPECT_EQ(folder_.names(),
              (std::vector<std::string>{"two-00000.png", "two-00001.png", "two-00002.png", "two-00003.png", "two.txt"}));
    const auto colors = [&](const std::string& name) {
        const Picture shown = picture(name);
        std::vector<int> red_left{0, 0};
        for (int x = 0; x < shown.width; ++x) {
            if (shown.at(x, 20)[0] == 255) ++red_left[x < 20 ? 0 : 1];
        }
        return red_left;
    };
    EXPECT_GT(colors("two-00000.png")[1], 2);
    EXPECT_EQ(colors("two-00000.png")[0], 0);
    EXPECT_GT(colors("two-00001.png")[0], 2);  // from the right the red one is in front
    EXPECT_GT(colors("two-00002.png")[0], 2);
    EXPECT_EQ(colors("two-00002.png")[1], 0);
    EXPECT_EQ(colors("two-00003.png")[0] + colors("two-00003.png")[1], 0);  // behind the blue one
    // Nothing turns about x that lies on it; and a scene's own camera goes round as well.
    expect_done({"two.txt", "--turntable", "2", "--axis", "x", "-s", "41x41", "-o", "x{frame}"});
    EXPECT_EQ(picture("x0.png"), picture("x1.png"));
    EXPECT_EQ(render({"two.txt", "--axis", "x"}).status, 2);
}

TEST_F(Frames, TurnWhileTheyRunAndTheLightStays) {
    folder_.write("a.xyz", "1\n\nO 0 0 0\n1\n\nO 0 0 0\n1\n\nO 0 0 0\n");
    expect_done({"a.xyz", "--frames", "all", "--turntable", "2", "-s", "32x32", "--shade", "studio", "--lights", "16"});
    EXPECT_EQ(picture("a-00000.png"), picture("a-00002.png"));
    const Picture front = picture("a-00000.png");
    const Picture back = picture("a-00001.png");
    // The key light, above left of the first eye, is behind the other one's sphere.
    EXPECT_GT(front.at(12, 12)[0], back.at(12, 12)[0]);
}

TEST_F(Frames, SayOnceThatTheyShowNoSphere) {
    folder_.write("view.toml", "[camera]\neye = [0, 0, 9]\ncenter = [0, 0, 10]\nright = [1, 0, 0]\nup = [0, 1, 0]\n");
    folder_.write("a.xyz", "1\n\nO 0 0 0\n1\n\nO 0 0 0\n1\n\nO 0 0 0\n");
    const Outcome outcome = run(cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "9x9", "--camera", "view.toml"}));
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors,
              "a.xyz, 0: no pixel shows a sphere; --fit frames all\n"
              "sphereview: 3 of 3 pictures show no sphere\n");
}

// One that is written to a pipe is done when the pipe has taken it; the next one waits for a reader.
TEST_F(Frames, SayHowManyWereDoneWhenInterrupted) {
    folder_.write("a.xyz", moving_atom(9));
    ASSERT_EQ(mkfifo(folder_.path("3.png").c_str(), 0600), 0);
    Running program(cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "9x9", "-o", "{frame}.png"}));
    ASSERT_TRUE(eventually([&] { return folder_.has("2.png"); }));
    program.send(SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 130) << outcome;
    EXPECT_TRUE(outcome.errors == "sphereview: interrupted; 3 of 9 pictures were done\n") << outcome;
    EXPECT_FALSE(folder_.has("4.png"));
}

#ifndef SPHEREVIEW_SANITIZED  // AddressSanitizer reserves more address space than any sensible limit
// Threads that have a frame each need more than one that does all.
TEST_F(Frames, AreDoneOneAtATimeWhereThereIsNoMemoryForSeveral) {
    std::string text;
    for (int frame = 0; frame < 4; ++frame) {
        text += "20000\n\n";
        for (int i = 0; i < 20'000; ++i) text += "O " + std::to_string(i % 100) + " " + std::to_string(i / 100 + frame) + " 0\n";
    }
    folder_.write("a.xyz", text);
    Command command = cpu_render(folder_, {"a.xyz", "--frames", "all", "-s", "700x700", "--no-sync", "-o", "{frame}.png"});
    command.most_memory = 130'000'000;
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.errors, "");
}
#endif

#ifdef __linux__

// What a run says and leaves, but for the times.
std::string all_of(const TemporaryFolder& folder, const Outcome& outcome) {
    std::string all = std::to_string(outcome.status) + "\n" + outcome.errors;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) all += line.substr(0, line.find("\"timings_ms\"")) + "\n";
    std::vector<std::string> names;
    if (folder.has("out")) {
        for (const auto& entry : std::filesystem::directory_iterator(folder.path("out"))) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) all += name + "\n" + folder.read("out/" + name);
    return all;
}

// Where a core has a frame of its own, all comes as from one that does one frame after the other: pictures, words, lines, errors.
TEST_F(Frames, SeveralAtOnceAreAsOneAfterTheOther) {
    std::string text;
    for (int frame = 0; frame < 12; ++frame) {
        const int count = 200 * (frame % 3 == 0 ? 9 : 1);  // one takes longer than the next
        text += std::to_string(count) + "\nProperties=species:S:1:pos:R:3:v:R:1\n";
        for (int i = 0; i < count; ++i) {
            text += (i % 3 == 0 ? "O " : "H ") + std::to_string(i % 17) + " " + std::to_string(i % 13 + frame) + " " +
                    std::to_string(i % 7) +
                    (frame == 7 && i == 3 ? " x\n"
                     : frame == 4         ? " 5\n"
                                          : " 1\n");
        }
    }
    folder_.write("a.xyz", text);
    const std::vector<std::vector<std::string>> runs = {
        {"--json", "--manifest", "out/m.jsonl", "-o", "out/{frame:02}"},
        {"--color-by", "v", "--legend", "--verbose", "-o", "out/{frame:02}", "--shade", "normal"},
        {"--frames", "0:7", "-o", "-"},
        {"-o", "-"},
    };
    for (const std::vector<std::string>& more : runs) {
        std::vector<std::string> arguments = {"a.xyz", "-s", "60x40", "--no-sync", "--fit", "first", "--frames"};
        if (more.front() != "--frames") arguments.emplace_back("all");
        arguments.insert(arguments.end(), more.begin() + (more.front() == "--frames" ? 1 : 0), more.end());
        SCOPED_TRACE(testing::PrintToString(arguments));
        const std::string at_once = all_of(folder_, render(arguments));
        std::filesystem::remove_all(folder_.path("out"));
        const OneCore one;
        const std::string alone = all_of(folder_, render(arguments));
        std::filesystem::remove_all(folder_.path("out"));
        EXPECT_FALSE(contains(alone, "(see 'sphereview render")) << "refused";
        EXPECT_TRUE(at_once == alone) << at_once.substr(0, 2000) << "\n-- alone:\n" << alone.substr(0, 2000);
    }
}

#endif

}  // namespace
}  // namespace sphereview::test

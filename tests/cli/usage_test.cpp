// The command line itself: help, versions, and mistakes in it.
#include <gtest/gtest.h>

#include <map>

#include "app/version.hpp"
#include "cli/fails.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"
#include "support/trials.hpp"

namespace sphereview::test {
namespace {

// Starting a sanitised program takes long.
constexpr std::size_t some = is_sanitized ? 4 : 1;

TEST(Usage, EachCommandHasHelpWithExamplesAndExitStatus) {
    const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases = {
        {{"--help"},
         {"render", "convert", "explain", "compare", "doctor", "Exit status: 0 done; 1 ", "2 wrong usage", "3 nothing",
          "4 the output", "129, 130, 143 interrupted"}},
        {{"-h"}, {"render", "Exit status"}},
        {{"render", "--help"},
         {"Examples:", "sphereview render scene.txt", "Exit status: 0", "--output", "--size", "--background", "--backend",
          "--device", "--expect", "--diff", "--timings", "--json", "--verbose", "--samples", "SPHEREVIEW_BACKEND"}},
        {{"convert", "--help"}, {"Examples:", "sphereview convert scene.txt scene.toml", "--to", "Exit status"}},
        {{"compare", "--help"},
         {"Examples:", "sphereview compare mine.png scene.txt", "PICTURE ... SCENE", "--diff", "Exit status"}},
        {{"explain", "--help"}, {"Examples:", "sphereview explain scene.txt --pixel", "--json", "Exit status"}},
        {{"doctor", "--help"}, {"Examples:", "sphereview doctor --json", "--timeout", "Exit status 0 if any backend works"}},
    };
    for (const auto& [arguments, parts] : cases) {
        SCOPED_TRACE(arguments.front());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.errors, "");
        for (const std::string& part : parts) EXPECT_TRUE(contains(outcome.output, part));
    }
}

TEST(Usage, VersionIsTheProjects) {
    const Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "sphereview " + std::string(version) + "\n");
}

TEST(Usage, MistakesAreOneLineWithASuggestionAndStatus2) {
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{""}, "unknown command ''"},
        {{"rendr", "a.txt"}, "unknown command 'rendr'; did you mean 'render'?"},
        {{"Convert"}, "did you mean 'convert'?"},
        {{"docter"}, "did you mean 'doctor'?"},
        {{"help"}, "unknown command 'help'; did you mean '--help'? (see 'sphereview --help')"},
        {{"version"}, "unknown command 'version'; did you mean '--version'?"},
        {{"-v"}, "unknown option '-v'; did you mean '--view' or '--version'? (see 'sphereview view --help')"},
        {{"doctor", "-v"}, "unknown option '-v'; did you mean '--version'?"},
        {{"render", "a.txt", "--shade", "Studio"},
         "expected flat, headlight, normal, depth, id or studio; did you mean 'studio'? (see"},
        {{"render", "a.txt", "--backend=CPU"}, "expected auto, egl, osmesa, wgl or cpu; did you mean 'cpu'? (see"},
        {{"\x1b[31mred"}, "'\\x1b[31mred'"},
        {{"--versoin"}, "unknown option '--versoin'; did you mean '--version'?"},
        {{"render"}, "SCENE: found no value, expected the name of a file (see 'sphereview render --help')"},
        {{"render", "a.txt", "--exect", "b.png"}, "unknown option '--exect'; did you mean '--expect'?"},
        {{"render", "--bakend=cpu", "a.txt"}, "unknown option '--bakend'; did you mean '--backend'?"},
        {{"render", "a.txt", "-S", "3x3"}, "unknown option '-S'; did you mean '-s'?"},
        {{"render", "a.txt", "-x"}, "unknown option '-x' (see 'sphereview render --help')"},
        {{"--bakground", "white"}, "unknown option '--bakground'; did you mean '--background'? (see 'sphereview view --help')"},
        {{"a.txt", "b.txt"}, "unexpected argument 'b.txt' (see 'sphereview view --help')"},
        {{"a.txt", "--size", "0x3"},
         "--size: found '0x3', expected WIDTHxHEIGHT, such as 1000x1000: sides of at least 1 pixel, at most "
         "429496729 pixels (see 'sphereview view --help')"},
        {{"view", "--shader-dir", "no/such/folder"}, "--shader-dir: found 'no/such/folder', expected a folder"},
        {{"render", "a.txt", "-s"}, "--size: found no value, expected WIDTHxHEIGHT, such as"},
        {{"render", "--output=", "a.txt"}, "--output: found no value, expected the name of a file (see"},
        {{"render", "a.txt", "-o", "-s", "3x3"}, "--output: found the option '-s', expected the name of a file (see"},
        {{"render", "a.txt", "-s", "3x3", "--size=4x4"}, "--size: found '3x3' and '4x4', expected only one value"},
        {{"render", "a.txt", "--device", "first"}, "--device: found 'first', expected the number of an EGL device"},
        {{"render", "a.txt", "--device", "-1"}, "--device: found '-1', expected the number of an EGL device"},
        {{"render", "a.txt", "-o", ""}, "--output: found no value, expected the name of a file"},
        {{"render", "a.txt", "--expect", "b.png", "--diff", ""}, "--diff: found no value, expected the name of a file"},
        {{"convert", "", "b.txt"}, "IN: found no value, expected the name of a file"},
        {{"convert", "a.txt", ""}, "OUT: found no value, expected the name of a file"},
        {{"render", "a.txt", "--device", "0", "--backend", "cpu"}, "--backend: found 'cpu', expected egl with --device"},
        {{"render", "a.txt", "--backend", "vulkan"}, "--backend: found 'vulkan', expected auto, egl, osmesa, wgl or cpu"},
        {{"render", "a.txt", "--backend", ""}, "--backend: found no value"},
        {{"render", "a.txt", "--fit", "--no-fit"}, "--fit does not go with --no-fit (see"},
        {{"render", "a.txt", "--view=top", "--no-fit"}, "--no-fit does not go with --view"},
        {{"render", "a.txt", "--diff", "d.png"}, "--diff needs --expect"},
        {{"render", "a.txt", "--legend"}, "sphereview: --legend needs --color-by (see"},
        {{"render", "a.txt", "--size-by", "mass", "--radii", "vdw"}, "sphereview: --size-by does not go with --radii (see"},
        {{"render", "a.txt", "--movie", "a.mp4"}, "sphereview: --movie needs --frames or --turntable (see"},
        {{"wiev", "a"}, "unknown command 'wiev'; did you mean 'view'? (see"},
        {{"convert", "a.txt"}, "OUT: found no value, expected the name of a file (see"},
        {{"convert", "a.txt", "b.toml", "c.toml"}, "unexpected argument 'c.toml'"},
        {{"convert", "a.txt", "b", "--to", "yaml"}, "--to: found 'yaml', expected text or toml"},
        {{"convert", "a.txt", "b", "--to", ""}, "--to: found no value"},
        {{"convert", "a.txt", "-"}, "add --to FORMAT: text or toml"},
        {{"explain", "a.txt"}, "--pixel: found no value, expected X,Y, such as 500,500 (see"},
        {{"explain", "a.txt", "--pixle", "5,5"}, "unknown option '--pixle'; did you mean '--pixel'?"},
        {{"explain", "a.txt", "--pixel", "5"}, "--pixel: found '5', expected X,Y"},
        {{"explain", "a.txt", "--pixel", "1000,0"}, "expected a pixel from 0,0 to 999,999"},
        {{"explain", "a.txt", "--pixel", "-1,0"}, "expected a pixel from 0,0 to 999,999"},
        {{"explain", "a.txt", "--pixel", "3,3", "-s", "3x3"}, "expected a pixel from 0,0 to 2,2"},
        {{"explain", "a.txt", "--pixel", "0,0", "-s", "0x3"}, "(see 'sphereview explain --help')"},
        {{"explain", "a.txt", "--pixel", "99999999999,0"}, "--pixel: found"},
        {{"doctor", "--timeout", "0"}, "--timeout: found '0', expected a number of seconds above 0, at most 3600"},
        {{"doctor", "--timeout", "nan"}, "--timeout: found 'nan', expected"},
        {{"doctor", "--timeout"}, "--timeout: found no value, expected a number of seconds above 0, at most 3600 (see"},
        {{"a.txt", "--redraw-log"}, "--redraw-log: found no value, expected the name of a file (see"},
        {{"render", "a.txt", "--view"}, "--view: found no value, expected front, back"},
        {{"render", "a.txt", "--json=no"}, "--json: found 'no', expected no value (see 'sphereview render --help')"},
        {{"render", "a.txt", "--fit="}, "--fit: found '', expected no value"},
        {{"render", "--help=render"}, "--help: found 'render', expected no value"},
        {{"--version=2"}, "--version: found '2', expected no value (see 'sphereview --help')"},
        {{"doctor", "everything"}, "unexpected argument 'everything'"},
    };
    for (std::size_t i = 0; i < cases.size(); i += some) {
        const auto& [arguments, said] = cases[i];
        SCOPED_TRACE(said);
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with("sphereview: ")) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
    }
}

TEST(Usage, ValuesThatMakeNoSenseAreRefusedBeforeAnyWork) {
    struct Case {
        std::string option;
        std::string expected;
        std::vector<std::string> values;
        std::vector<std::vector<std::string>> commands = {{"render", "missing.txt"}};
    };
    const std::vector<std::vector<std::string>> with_scenes = {{"view", "missing.txt"},
                                                               {"render", "missing.txt"},
                                                               {"convert", "missing.txt", "b.txt"},
                                                               {"explain", "missing.txt", "--pixel", "1,1"}};
    const std::vector<Case> cases = {
        {"--size",
         "WIDTHxHEIGHT, such as 1000x1000: sides of at least 1 pixel, at most 429496729 pixels",
         {"0x5", "5x0", "-5x5", "1000000x1000000", "429496730x1", "99999999999x1", "1x99999999999999999999", "10", "10x", "x10",
          "10x10x10", "10x10.5", "1e3x5", " 5x5", "big", ""}},
        {"--samples", "1, 4 or 16", {"0", "2", "3", "-4", "4.0", "64", "many", "", "4 ", "99999999999999999999"}},
        {"--background",
         "black, white, transparent or #rrggbb",
         {"red", "#ff80", "#gggggg", "#ff80001", "BLACK", " white", "0xff8000", ""}},
        {"--shade", "flat, headlight, normal, depth, id or studio", {"Flat", "lambert", ""}},
        {"--lights", "a whole number from 16 to 1024", {"15", "1025", "64.5", "many", ""}},
        {"--sky", "a number from 0 to 1", {"-0.1", "1.1", "nan", "blue", ""}},
        {"--key", "a number from 0 to 1", {"-0.1", "1.1", "nan", "high", ""}},
        {"--sun-strength", "a number from 0.001 to 4", {"0", "0.0001", "4.1", "inf", ""}},
        {"--sun",
         "X,Y,Z, not all 0, from the scene to the sun, or AZIMUTH,ELEVATION in degrees, from where the sun shines as --view looks",
         {"0,0,0", "1", "1,2,3,4", "0,91", "1,2,x", "1,,2", "1,2,", "inf,0,0", "front", ""}},
        {"--view",
         "front, back, left, right, top, bottom, iso, AZIMUTH,ELEVATION in degrees or a saved view's name",
         {"0,91", " ", ""}},
        {"--frame", "the number of a frame, from 0", {"1.5", "x", "99999999999999999999"}},
        {"--frame", "the number of a frame, from 0", {"-1"}, with_scenes},
        {"--radius", "a number above 0", {"-1", "nan", "inf", "1e999", "x"}},
        {"--radius", "a number above 0", {"0"}, with_scenes},
    };
    const std::map<std::string, std::string> suggestions = {{"Flat", "flat"}, {"BLACK", "black"}, {" white", "white"}};
    for (const auto& [option, expected, values, commands] : cases) {
        for (const auto& words : commands) {
            for (std::size_t i = 0; i < values.size(); i += some) {
                const std::string& value = values[i];
                std::vector<std::string> arguments = words;
                arguments.insert(arguments.end(), {option, value});
                const Outcome outcome = run(arguments);
                EXPECT_EQ(outcome.status, 2) << outcome;
                EXPECT_EQ(outcome.output, "");
                const std::string suggested =
                    suggestions.contains(value) ? "; did you mean '" + suggestions.at(value) + "'?" : std::string();
                EXPECT_EQ(outcome.errors, "sphereview: " + option + ": found " + (value.empty() ? "no value" : "'" + value + "'") +
                                              ", expected " + expected + suggested + " (see 'sphereview " + words[0] +
                                              " --help')\n");
            }
        }
    }
    // Options of a light that nothing would show.
    for (const char* option : {"--lights=64", "--sky=0.5", "--key=0.5", "--sun=1,2,3", "--sun-strength=1"}) {
        const std::string name = std::string(option).substr(0, std::string(option).find('='));
        EXPECT_EQ(run({"render", "missing.txt", option}).errors,
                  "sphereview: " + name + " needs --shade studio (see 'sphereview render --help')\n");
    }
    // A window shows what is asked for.
    EXPECT_EQ(run({"view", "missing.txt", "--shade", "flat", "--sun", "1,2,3"}).errors,
              "sphereview: --sun needs --shade studio (see 'sphereview view --help')\n");
    EXPECT_TRUE(run({"render", "missing.txt", "--size", "429496729x1"}).errors.starts_with("missing.txt: "));
}

TEST(Usage, WhatFollowsTheCommandIsAFileWhateverItIsCalled) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"render", "-s", "3x3", "--", "-absent.txt"},
                                                      {"render", "-s", "3x3", "--expect", "g.png", "doctor"},
                                                      {"convert", "doctor", "render"}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "cannot be read: No such file or directory"));
    }
}

TEST(Usage, HelpWinsOverLaterMistakes) {
    for (const char* mistake : {"--unknown", "--size", "--size=3"}) {
        const Outcome outcome = run({"render", "--help", mistake});
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_TRUE(contains(outcome.output, "Usage: sphereview render"));
    }
}

// Without a display the window cannot open; with one, tests/ui/ has what comes next.
TEST(Usage, APathAsFirstWordIsASceneForTheWindow) {
    const TemporaryFolder folder;
    folder.write("scene", red_scene);
    folder.write("sub/scene.txt", red_scene);
    // A file that exists, words that look like paths, an option, standard input, and nothing.
    const std::vector<std::vector<std::string>> lines_that_open = {
        {"scene"}, {"./scene"}, {"sub/scene.txt"}, {"--background", "white", "scene"}, {"--", "scene"}, {"view", "scene"},
        {"-"},     {}};
    const auto started = [&](const std::vector<std::string>& arguments, const std::optional<std::string>& display) {
        return run({.arguments = arguments,
                    .folder = folder.path(),
                    .input = red_scene,
                    .environment = {{"DISPLAY", display}, {"WAYLAND_DISPLAY", std::nullopt}, {"HOME", folder.path()}}});
    };
    for (const auto& arguments : lines_that_open) {
        SCOPED_TRACE(testing::PrintToString(arguments));
        EXPECT_TRUE(fails(started(arguments, std::nullopt), 3, "sphereview: there is no display"));
    }
    // Nor where there is no such display.
    const Outcome nowhere = started({"scene"}, ":65000");
    EXPECT_TRUE(fails(nowhere, 3, "sphereview: "));
    for (const char* instead : {"sphereview render", "sphereview doctor"}) EXPECT_TRUE(contains(nowhere.errors, instead));
    // Its name is no more than a name: it steers no terminal and makes no line of its own.
    const Outcome forged = started({"scene"}, "\x1b[2J\nFORGED: ok");
    EXPECT_TRUE(fails(forged, 3, "sphereview: there is no display to open a window on: "));
    EXPECT_TRUE(contains(forged.errors, R"(\x1b[2J\x0aFORGED: ok)")) << forged;
    EXPECT_FALSE(contains(forged.errors, "\nFORGED") || contains(forged.errors, "\x1b")) << forged;
    // What is wrong with the scene is said first.
    folder.write("broken.txt", bad_scene);
    EXPECT_TRUE(fails(started({"broken.txt"}, std::nullopt), 2, "broken.txt:4:1: "));
    EXPECT_TRUE(fails(started({"view", "missing.txt"}, std::nullopt), 2, "missing.txt: "));
    const Outcome outcome = run({"scene"});  // but not where there is no such file
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "unknown command 'scene'"));
}

}  // namespace
}  // namespace sphereview::test

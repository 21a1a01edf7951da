// The command line itself: help, versions, and mistakes in it.
#include <gtest/gtest.h>

#include "app/version.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

TEST(Usage, EachCommandHasHelpWithExamplesAndExitStatus) {
    const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> cases = {
        {{"--help"},
         {"render", "convert", "explain", "doctor", "Exit status: 0 done; 1 ", "2 wrong usage", "3 nothing", "4 the output",
          "130, 143"}},
        {{"-h"}, {"render", "Exit status"}},
        {{"render", "--help"},
         {"Examples:", "sphereview render scene.txt", "Exit status: 0", "--output", "--size", "--background", "--backend",
          "--device", "--expect", "--diff", "--timings", "--json", "--verbose", "SPHEREVIEW_BACKEND"}},
        {{"convert", "--help"}, {"Examples:", "sphereview convert scene.txt scene.toml", "--to", "Exit status"}},
        {{"explain", "--help"}, {"Examples:", "sphereview explain scene.txt --pixel", "--json", "Exit status"}},
        {{"doctor", "--help"}, {"Examples:", "sphereview doctor --json", "--timeout", "Exit status 0 if any backend works"}},
    };
    for (const auto& [arguments, parts] : cases) {
        SCOPED_TRACE(arguments.front());
        Command command;
        command.arguments = arguments;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome;
        EXPECT_EQ(outcome.errors, "");
        for (const std::string& part : parts) EXPECT_TRUE(contains(outcome.output, part));
        EXPECT_FALSE(contains(outcome.output, "--probe"));  // only doctor itself uses it
    }
}

TEST(Usage, VersionIsTheProjects) {
    const Outcome outcome = run({"--version"});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_EQ(outcome.output, "sphereview " + std::string(version) + "\n");
}

struct Mistake {
    std::vector<std::string> arguments;
    std::string said;
};

TEST(Usage, MistakesAreOneLineWithASuggestionAndStatus2) {
    const std::vector<Mistake> cases = {
        {{}, "expected a command: render, convert, explain or doctor"},
        {{""}, "unknown command ''"},
        {{"rendr", "a.txt"}, "unknown command 'rendr'; did you mean 'render'?"},
        {{"Convert"}, "did you mean 'convert'?"},
        {{"docter"}, "did you mean 'doctor'?"},
        {{"--versoin"}, "unknown option '--versoin'; did you mean '--version'?"},
        {{"render"}, "SCENE is required"},
        {{"render", "a.txt", "--exect", "b.png"}, "unknown option '--exect'; did you mean '--expect'?"},
        {{"render", "--bakend=cpu", "a.txt"}, "unknown option '--bakend'; did you mean '--backend'?"},
        {{"render", "a.txt", "-s"}, "--size"},
        {{"render", "a.txt", "--device", "first"}, "--device"},
        {{"render", "a.txt", "--device", "0", "--backend", "cpu"}, "--device picks an EGL device"},
        {{"render", "a.txt", "--backend", "vulkan"}, "--backend: found 'vulkan', expected auto, egl, osmesa or cpu"},
        {{"render", "a.txt", "--backend", ""}, "--backend: found ''"},
        {{"render", "a.txt", "--diff", "d.png"}, "--diff needs --expect"},
        {{"convert", "a.txt"}, "OUT is required"},
        {{"convert", "a.txt", "b.toml", "c.toml"}, "unexpected argument 'c.toml'"},
        {{"convert", "a.txt", "b", "--to", "yaml"}, "--to: found 'yaml', expected text or toml"},
        {{"convert", "a.txt", "b", "--to", ""}, "--to: found ''"},
        {{"convert", "a.txt", "-"}, "add --to text or --to toml"},
        {{"explain", "a.txt"}, "--pixel is required"},
        {{"explain", "a.txt", "--pixel", "5"}, "--pixel: found '5', expected X,Y"},
        {{"explain", "a.txt", "--pixel", "1000,0"}, "expected a pixel from 0,0 to 999,999"},
        {{"explain", "a.txt", "--pixel", "-1,0"}, "expected a pixel from 0,0 to 999,999"},
        {{"explain", "a.txt", "--pixel", "3,3", "-s", "3x3"}, "expected a pixel from 0,0 to 2,2"},
        {{"explain", "a.txt", "--pixel", "0,0", "-s", "0x3"}, "--size: found '0x3'"},
        {{"explain", "a.txt", "--pixel", "99999999999,0"}, "--pixel: found"},
        {{"doctor", "--timeout", "0"}, "--timeout"},
        {{"doctor", "--timeout", "nan"}, "--timeout"},
        {{"doctor", "--timeout", "soon"}, "--timeout"},
        {{"doctor", "everything"}, "unexpected argument 'everything'"},
        {{"doctor", "--probe", "vulkan"}, "unknown backend"},
    };
    for (const auto& [arguments, said] : cases) {
        SCOPED_TRACE(said);
        Command command;
        command.arguments = arguments;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(lines(outcome.errors).size(), 1U) << outcome;
        EXPECT_TRUE(outcome.errors.starts_with("sphereview: ")) << outcome;
        EXPECT_TRUE(contains(outcome.errors, said));
    }
}

TEST(Usage, WhatFollowsTheCommandIsAFileWhateverItIsCalled) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"render", "-s", "3x3", "--", "-absent.txt"},
                                                      {"render", "-s", "3x3", "--expect", "g.png", "doctor"},
                                                      {"convert", "doctor", "render"}}) {
        Command command;
        command.arguments = arguments;
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, "cannot be read: No such file or directory"));
    }
}

TEST(Usage, APathAsFirstWordIsToldHowToRenderIt) {
    const TemporaryFolder folder;
    folder.write("scene", red_scene);
    // A file that exists, words that look like paths, and standard input.
    for (const char* word : {"scene", "scene.txt", "sub/scene", "./render", "-"}) {
        SCOPED_TRACE(word);
        Command command;
        command.arguments = {word};
        command.folder = folder.path();
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 2) << outcome;
        EXPECT_TRUE(contains(outcome.errors, std::string("sphereview render ") + word));
    }
    Command command;
    command.arguments = {"scene"};  // but not where there is no such file
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "unknown command 'scene'"));
}

TEST(Usage, AWrongFirstWordIsSafeForTheTerminal) {
    const Outcome outcome = run({"\x1b[31mred"});
    EXPECT_EQ(outcome.status, 2) << outcome;
    EXPECT_TRUE(contains(outcome.errors, "'\\x1b[31mred'"));
}

}  // namespace
}  // namespace sphereview::test

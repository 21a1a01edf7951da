// What packages take from the program: its licences, its manual page and completions. All are written from the same declarations as
// --help.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "app/version.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

const std::vector<std::string> commands = {"view", "render", "convert", "explain", "compare", "verify", "doctor"};

// The names of options that `sphereview [COMMAND] --help` lists in its first column.
std::set<std::string> options_in_help(const std::vector<std::string>& command) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    std::set<std::string> names;
    for (const std::string& line : lines(run(arguments).output)) {
        static const std::regex declared("^  (-[A-Za-z])?,?(--[a-z-]+)?.*");
        std::smatch found;
        if (!std::regex_match(line, found, declared)) continue;
        for (const std::size_t group : {1U, 2U}) {
            if (found[group].matched) names.insert(found[group]);
        }
    }
    return names;
}

// The part of a text from the line that is `first` up to the next line that begins with `next`.
std::string section(const std::string& text, const std::string& first, const std::string& next) {
    std::string found;
    bool inside = false;
    for (const std::string& line : lines(text)) {
        if (inside && line.starts_with(next)) break;
        inside = inside || line == first;
        if (inside) found += line + "\n";
    }
    return found;
}

TEST(Texts, TheManualNamesEveryCommandAndOptionOfHelp) {
    const Outcome manual = run({"--man"});
    ASSERT_EQ(manual.status, 0) << manual;
    EXPECT_TRUE(contains(manual.output, "sphereview " + std::string(version)));
    const auto expect_options = [](const std::string& text, const std::set<std::string>& options) {
        EXPECT_GE(options.size(), 2U);
        for (const std::string& option : options) {
            EXPECT_TRUE(contains(text, "\\fB" + std::regex_replace(option, std::regex("-"), "\\-") + "\\fR")) << option;
        }
    };
    expect_options(section(manual.output, ".SH OPTIONS", ".SH"), options_in_help({}));
    for (const std::string& command : commands) {
        SCOPED_TRACE(command);
        const std::string part = section(manual.output, ".SH COMMAND " + command, ".SH");
        expect_options(part, options_in_help({command}));
        EXPECT_TRUE(contains(part, "Examples:"));
    }
    EXPECT_TRUE(contains(manual.output, ".SH EXIT STATUS\nExit status: 0 done; 1 "));
}

TEST(Texts, TheManualIsRoffWithoutAMistake) {
    if (!std::filesystem::exists("/usr/bin/groff")) GTEST_SKIP() << "there is no groff";
    Command groff;
    groff.program = "/usr/bin/groff";
    groff.arguments = {"-man", "-Tascii", "-ww", "-z"};
    groff.input = run({"--man"}).output;
    const Outcome outcome = run(groff);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.errors, "");
}

TEST(Texts, CompletionsNameEveryCommandAndOptionOfHelp) {
    const std::string bash = run({"--completion", "bash"}).output;
    const std::string zsh = run({"--completion", "zsh"}).output;
    const std::string fish = run({"--completion", "fish"}).output;
    for (const std::string& command : commands) {
        SCOPED_TRACE(command);
        const std::string in_zsh = section(zsh, "    ('" + command + "') _arguments -S \\", "    (");
        const std::string condition = command == "view"
                                          ? "'not __fish_seen_subcommand_from render convert explain compare verify doctor'"
                                          : "'__fish_seen_subcommand_from " + command + "'";
        for (const std::string& option : options_in_help({command})) {
            EXPECT_TRUE(
                matches(line_with(bash, "    '" + command + "') options='"), ".* '?" + option + "[ '].*|.*'" + option + " .*"));
            EXPECT_TRUE(contains(in_zsh, option + (contains(in_zsh, option + "=[") ? "=[" : "[")));
            const bool is_long = option.starts_with("--");
            const std::string in_fish = is_long ? " -l " + option.substr(2) + " " : " -s " + option.substr(1) + " ";
            const std::vector<std::string> fish_lines = lines(fish);
            EXPECT_TRUE(std::ranges::any_of(fish_lines, [&](const std::string& line) {
                return line.find(condition) != std::string::npos && line.find(in_fish) != std::string::npos;
            })) << option;
        }
    }
}

// What bash offers for the last of the words.
std::vector<std::string> offered(const std::string& words) {
    Command bash;
    bash.program = "/bin/bash";
    bash.arguments = {"--norc", "-c", R"(compopt() { :; }
. /dev/stdin
COMP_WORDS=(sphereview )" + words + R"()
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
_sphereview
printf '%s\n' "${COMPREPLY[@]}")"};
    bash.input = run({"--completion", "bash"}).output;
    const Outcome outcome = run(bash);
    EXPECT_EQ(outcome.errors, "");
    return lines(outcome.output);
}

TEST(Texts, BashCompletesCommandsOptionsAndValues) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(offered("re"), Words{"render"});
    EXPECT_EQ(offered("--lic"), Words{"--licenses"});
    EXPECT_EQ(offered("--shader"), Words{"--shader-dir"});  // of `view`
    EXPECT_EQ(offered("render scene.txt --exp"), Words{"--expect"});
    EXPECT_EQ(offered("scene.txt --exp"), Words{""});  // `view` has none
    EXPECT_EQ(offered("render --backend ''"), (Words{"auto", "egl", "osmesa", "wgl", "cpu"}));
    EXPECT_EQ(offered("render --backend ="), (Words{"auto", "egl", "osmesa", "wgl", "cpu"}));
    EXPECT_EQ(offered("render --backend = c"), Words{"cpu"});
    EXPECT_EQ(offered("render --samples 1"), (Words{"1", "16"}));
    EXPECT_EQ(offered("convert a.xyz b --to t"), (Words{"text", "toml"}));
    EXPECT_EQ(offered("--completion ''"), (Words{"bash", "zsh", "fish"}));
    EXPECT_EQ(offered("render --size ''"), Words{""});
}

TEST(Texts, OtherShellsTakeTheirScripts) {
    for (const std::string shell : {"zsh", "fish"}) {
        if (!std::filesystem::exists("/usr/bin/" + shell)) continue;
        const TemporaryFolder folder;
        Command check;
        check.program = "/usr/bin/" + shell;
        check.arguments = {"-n", folder.write("script", run({"--completion", shell}).output)};
        const Outcome outcome = run(check);
        EXPECT_EQ(outcome.status, 0) << shell << outcome;
        EXPECT_EQ(outcome.errors, "") << shell;
    }
    const Outcome unknown = run({"--completion", "tcsh"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.errors, "sphereview: --completion: found 'tcsh', expected bash, zsh or fish (see 'sphereview --help')\n");
}

TEST(Texts, LicensesAreOurOwnAndThoseOfTheParts) {
    const Outcome outcome = run({"--licenses"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.output.starts_with("MIT License\n\nCopyright (c) "));
    EXPECT_TRUE(outcome.output.ends_with("\n") && !outcome.output.ends_with("\n\n"));
    const std::vector<std::string> parts = {"Boost.Multiprecision: BSL-1.0",
                                            "CLI11: BSD-3-Clause",
                                            "Dear ImGui: MIT",
                                            "GLM: MIT",
                                            "glad's loaders for OpenGL and EGL: MIT AND Apache-2.0",
                                            "JSON for Modern C++: MIT",
                                            "stb: MIT OR Unlicense",
                                            "toml++: MIT"};
    for (const std::string& part : parts) {
        EXPECT_TRUE(contains(outcome.output, "\n  " + part + ", https://"));
        EXPECT_TRUE(contains(outcome.output, "\n" + std::string(80, '-') + "\n" + part + "\nhttps://"));
    }
    if (!std::filesystem::exists("/usr/share/doc/libimgui-dev/copyright")) return;
    EXPECT_TRUE(contains(outcome.output, "Boost Software License - Version 1.0"));
    EXPECT_TRUE(contains(outcome.output, "Omar Cornut"));
    EXPECT_TRUE(contains(outcome.output, "Apache License"));
    EXPECT_EQ(outcome.output.find("was not at hand"), std::string::npos);
}

}  // namespace
}  // namespace sphereview::test

// What `cmake --install` puts into a folder, from where the program must run wherever that folder is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/folders.hpp"
#include "support/picture.hpp"
#include "support/render.hpp"
#include "support/text_match.hpp"

namespace sphereview::test {
namespace {

Outcome run_tool(const std::string& program, const std::vector<std::string>& arguments) {
    Command command;
    command.program = program;
    command.arguments = arguments;
    return run(command);
}

// The build, installed in a folder that goes with the object.
class Installed : public testing::Test {
protected:
    Installed() {
        const Outcome outcome = run_tool(CMAKE, {"--install", build_file(""), "--prefix", folder_.path()});
        EXPECT_EQ(outcome.status, 0) << outcome;
    }

    std::string file(const std::string& name) const {
        EXPECT_TRUE(folder_.has(name)) << name;
        return folder_.path(name);
    }

    // The tool's verdict on an installed file, if there is such a tool here.
    void expect_valid(const std::string& tool, std::vector<std::string> arguments, const std::string& name) const {
        const std::string program = "/usr/bin/" + tool;
        arguments.push_back(file(name));
        if (!std::filesystem::exists(program)) return;
        const Outcome outcome = run_tool(program, arguments);
        EXPECT_EQ(outcome.status, 0) << name << ": " << outcome;
    }

    TemporaryFolder folder_;
};

TEST_F(Installed, TheProgramRendersItsExampleScenes) {
    std::vector<std::string> arguments = {"render", "-s", "8x8", "--backend", "cpu", "-o", folder_.path("{name}.png")};
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("share/sphereview/scenes"))) {
        EXPECT_TRUE(std::filesystem::exists(source_file("scenes/" + entry.path().filename().string())));
#ifdef WITHOUT_GEMMI
        if (entry.path().extension() == ".cif") continue;
#endif
        arguments.push_back(entry.path().string());
        ++scenes;
    }
    EXPECT_GE(scenes, 8U);
    const Outcome outcome = run_tool(file("bin/sphereview"), arguments);
    EXPECT_EQ(outcome.status, 0) << outcome;
    const std::vector<std::string> names = folder_.names();
    EXPECT_EQ(std::ranges::count_if(names, [](const std::string& name) { return name.ends_with(".png"); }), std::ptrdiff_t(scenes));
}

TEST_F(Installed, DocsAreThereWithWhatTheyShow) {
    for (const std::string name : {"README.md", "CHANGELOG.md", "SECURITY.md", "docs/command-line.md", "docs/viewer.png"}) {
        EXPECT_EQ(folder_.read("share/doc/sphereview/" + name), TemporaryFolder().read(source_file(name))) << name;
    }
}

// The files that a page names, by [words](NAME) or [words](NAME#HEADING), beside it.
std::vector<std::string> linked_files(const std::string& page) {
    std::vector<std::string> files;
    for (std::size_t place = page.find("]("); place != std::string::npos; place = page.find("](", place + 1)) {
        const std::string target = page.substr(place + 2, page.find_first_of(")#\n", place + 2) - place - 2);
        if (!target.empty() && !contains(target, "://")) files.push_back(target);
    }
    return files;
}

TEST_F(Installed, LinksOfThePagesLeadSomewhere) {
    std::size_t links = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(file("share/doc/sphereview"))) {
        if (entry.path().extension() != ".md") continue;
        for (const std::string& name : linked_files(TemporaryFolder().read(entry.path().string()))) {
            const std::filesystem::path target = (entry.path().parent_path() / name).lexically_normal();
            EXPECT_TRUE(std::filesystem::exists(target) && target.string().starts_with(file("share/doc/sphereview")))
                << entry.path() << ": " << name;
            ++links;
        }
    }
    EXPECT_GE(links, 30U);
}

TEST_F(Installed, ThePythonModuleIsNot) {
    for (const std::string& name : folder_.names()) EXPECT_TRUE(name == "bin" || name == "share" || name == "lib") << name;
}

#ifdef SPHEREVIEW_DESKTOP

TEST_F(Installed, ADesktopFindsTheProgramAndItsFiles) {
    expect_valid("desktop-file-validate", {}, "share/applications/sphereview.desktop");
    expect_valid("appstreamcli", {"validate", "--no-net"}, "share/metainfo/io.github.sphereview.sphereview.metainfo.xml");
    for (const int size : {16, 22, 24, 32, 48, 64, 128, 256, 512}) {
        const std::string sides = std::to_string(size) + "x" + std::to_string(size);
        const Picture icon = decode_png(folder_.read("share/icons/hicolor/" + sides + "/apps/sphereview.png"));
        EXPECT_EQ(icon.width, size);
        EXPECT_EQ(icon.height, size);
        EXPECT_EQ(icon.at(0, 0).back(), 0) << "the corner is transparent";
        EXPECT_EQ(icon.at(size / 2, size / 2).back(), 255) << "the middle is not";
    }
    EXPECT_TRUE(contains(folder_.read("share/icons/hicolor/scalable/apps/sphereview.svg"), "<svg "));
    const std::string desktop = folder_.read("share/applications/sphereview.desktop");
    const std::string types = folder_.read("share/mime/packages/sphereview.xml");
    for (const std::string type : {"application/vnd.sphereview.scene", "chemical/x-xyz", "chemical/x-pdb", "chemical/x-mmcif",
                                   "chemical/x-cif", "chemical/x-lammps-dump", "chemical/x-gro", "chemical/x-vasp",
                                   "chemical/x-mdl-sdfile", "chemical/x-mdl-molfile", "chemical/x-pqr", "model/x-ply"}) {
        EXPECT_TRUE(contains(desktop, type + ";"));
        EXPECT_TRUE(contains(types, "<mime-type type=\"" + type + "\">"));
        EXPECT_TRUE(contains(folder_.read("share/metainfo/io.github.sphereview.sphereview.metainfo.xml"),
                             "<mediatype>" + type + "</mediatype>"));
    }
    const std::string update = "/usr/bin/update-mime-database";
    if (!std::filesystem::exists(update)) return;
    const Outcome outcome = run_tool(update, {file("share/mime")});
    EXPECT_EQ(outcome.status, 0) << outcome;
    EXPECT_TRUE(contains(folder_.read("share/mime/globs"), "chemical/x-xyz:*.extxyz\n"));
}

TEST_F(Installed, TheManualAndCompletionsAreTheProgramsOwn) {
    const Outcome manual = run_tool("/usr/bin/env", {"gzip", "-dc", file("share/man/man1/sphereview.1.gz")});
    EXPECT_EQ(manual.output, run({"--man"}).output);
    EXPECT_EQ(folder_.read("share/bash-completion/completions/sphereview"), run({"--completion", "bash"}).output);
    EXPECT_EQ(folder_.read("share/fish/vendor_completions.d/sphereview.fish"), run({"--completion", "fish"}).output);
    const std::string folder = folder_.has("share/zsh/vendor-completions") ? "vendor-completions" : "site-functions";
    EXPECT_EQ(folder_.read("share/zsh/" + folder + "/_sphereview"), run({"--completion", "zsh"}).output);
    EXPECT_TRUE(contains(folder_.read("share/doc/sphereview/copyright"), "Dear ImGui: MIT"));
}

#endif

}  // namespace
}  // namespace sphereview::test

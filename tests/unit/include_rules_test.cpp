#include "unit/include_rules.hpp"
#include "support/folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/input_file.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

const fs::path source = test::source_file("");

std::vector<fs::path> files_below(const std::string& folder) {
    std::vector<fs::path> files;
    if (!fs::exists(source / folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    return files;
}

// "scene" for src/scene/sphere.hpp, "app" for app/main.cpp, "panels" for app/panels/help.cpp.
std::string room_of(const fs::path& file) {
    const fs::path path = fs::relative(file, source);
    const std::string second = std::next(path.begin())->string();
    return *path.begin() == "src" || is_room(second) ? second : path.begin()->string();
}

bool is_cpp(const fs::path& file) { return file.extension() == ".cpp" || file.extension() == ".hpp"; }

}  // namespace

TEST(IncludeRules, HoldForEveryFile) {
    int checked = 0;
    for (const char* folder : {"src", "app"}) {
        for (const fs::path& file : files_below(folder)) {
            if (!is_cpp(file)) continue;
            ASSERT_TRUE(is_room(room_of(file))) << file << " lies in a folder that the table of rooms does not know";
            std::ifstream stream(file);
            int number = 0;
            for (std::string line; std::getline(stream, line);) {
                ++number;
                EXPECT_EQ(include_fault(room_of(file), line), "") << file.string() << ":" << number << ": " << line;
            }
            ++checked;
        }
    }
    EXPECT_GT(checked, 50);
}

TEST(IncludeRules, AllowWhatTheTableSays) {
    const std::vector<std::pair<const char*, const char*>> good = {
        {"base", "#include <vector>"},
        {"base", "#include \"base/error.hpp\""},
        {"base", "#include <unistd.h>"},
        {"base", "#include <sys/wait.h>"},
        {"formats", "#include <toml++/toml.h>"},
        {"scene", "  #  include   <glm/vec3.hpp>  // why"},
        {"image", "#include <stb_image.h>"},
        {"exact", "#include <boost/multiprecision/cpp_int.hpp>"},
        {"gpu", "#include <glad/gl.h>"},
        {"platform", "#include <dlfcn.h>"},
        {"platform", "#include <GLFW/glfw3.h>"},
        {"app", "#include \"gpu/gl_object.hpp\""},
        {"app", "#include <CLI/CLI.hpp>"},
        {"panels", "#include <imgui.h>"},
        {"viewer", "#include \"app/options.hpp\""},
        {"scene", "// #include <unistd.h>"},
        {"scene", "int include;"},
    };
    for (const auto& [room, line] : good) EXPECT_EQ(include_fault(room, line), "") << room << ": " << line;
}

TEST(IncludeRules, ForbidAllElse) {
    const std::vector<std::vector<const char*>> bad = {
        {"base", "#include \"scene/scene.hpp\"", "base may not include scene"},
        {"base", "#include <glm/vec3.hpp>", "base may not include glm"},
        {"scene", "#include \"image/image.hpp\"", "scene may not include image"},
        {"scene", "#include <unistd.h>", "scene may not include system"},
        {"scene", "#  include <sys/stat.h> // why", "scene may not include system"},
        {"image", "#include \"scene/scene.hpp\"", "image may not include scene"},
        {"exact", "#include \"cpu/cpu_renderer.hpp\"", "exact may not include cpu"},
        {"image", "#include <glm/vec3.hpp>", "image may not include glm"},
        {"cpu", "#include \"gpu/gl_object.hpp\"", "cpu may not include gpu"},
        {"gpu", "#include \"platform/gl_context.hpp\"", "gpu may not include platform"},
        {"gpu", "#include <EGL/egl.h>", "gpu may not include EGL"},
        {"platform", "#include \"scene/scene.hpp\"", "platform may not include scene"},
        {"platform", "#include \"gpu/gl_object.hpp\"", "platform may not include gpu"},
        {"app", "#include <unistd.h>", "app may not include system"},
        {"app", "#include \"viewer/viewer.hpp\"", "app may not include viewer"},
        {"panels", "#include \"gpu/live_picture.hpp\"", "panels may not include gpu"},
        {"panels", "#include \"viewer/viewer.hpp\"", "panels may not include viewer"},
        {"app", "#include <windows.h>", "app may not include system"},
        {"scene", "#include \"app/options.hpp\"", "scene may not include app"},
        {"scene", "#include \"sphere.hpp\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include \"../base/error.hpp\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include <base/error.hpp>", "a header of an unknown library"},
        {"scene", "#include <math.h>", "a header of an unknown library"},
        {"scene", "#include \"room/file.hpp\"", "no such room: room"},
        {"scene", "#include \"base//error.hpp\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include \"base/error.h\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include HEADER", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include<Eigen/Core>", "a header of an unknown library"},
    };
    for (const auto& line : bad) EXPECT_EQ(include_fault(line[0], line[1]), line[2]) << line[0] << ": " << line[1];
}

TEST(Files, HaveAtMostFourHundredLines) {
    int checked = 0;
    for (const char* folder : {"src", "app", "shaders", "tests", "bench"}) {
        for (const fs::path& file : files_below(folder)) {
            const InputFile content(file.string(), Content::binary);
            if (content.bytes().find('\0') != std::string_view::npos) continue;  // a picture
            EXPECT_LE(std::ranges::count(content.bytes(), '\n'), 400) << file;
            ++checked;
        }
    }
    EXPECT_GT(checked, 90);
}

}  // namespace sphereview

// Which file may include what: the arrows between the rooms (docs/architecture.md), and every #include against them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "support/folders.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string_view>;

// What a room may include beside itself and the C++ standard library: rooms, libraries, and "system".
const std::map<std::string_view, Names> allowed = {
    {"base", {"system", "zlib"}},
    {"scene", {"base", "glm"}},
    {"camera", {"base", "scene", "glm"}},
    {"edit", {"base", "scene", "glm"}},
    {"formats", {"base", "scene", "glm", "toml++", "gemmi"}},
    {"image", {"base", "stb", "png", "isa-l"}},
    {"exact", {"base", "scene", "glm", "boost"}},
    {"shade", {"base", "scene", "image", "exact", "glm"}},
    {"tiles", {"base", "scene", "edit", "exact", "glm"}},
    {"cpu", {"base", "scene", "exact", "tiles", "glm"}},
    {"gpu", {"base", "scene", "edit", "image", "exact", "shade", "tiles", "glad", "glm"}},
    {"platform", {"base", "glad", "EGL", "OSMesa", "GLFW", "fontconfig", "system"}},
    {"panels", {"base", "scene", "camera", "edit", "exact", "shade", "glm", "imgui"}},
    {"viewer",
     {"base", "scene", "camera", "edit", "formats", "image", "exact", "shade", "tiles", "cpu", "gpu", "platform", "panels", "app",
      "glm", "glad", "imgui"}},
    {"app", {"base", "scene",  "camera", "edit",  "formats", "image", "exact", "shade",  "tiles", "cpu",   "gpu", "platform",
             "glm",  "toml++", "stb",    "isa-l", "boost",   "glad",  "EGL",   "OSMesa", "GLFW",  "CLI11", "json"}},
    {"python",
     {"base", "scene", "camera", "formats", "image", "exact", "shade", "tiles", "cpu", "gpu", "platform", "app", "glm",
      "pybind11"}},
};

// How the headers of a library begin. "system" is what only some operating systems have.
const std::vector<std::pair<std::string_view, Names>> libraries = {
    {"glm", {"glm/"}},
    {"toml++", {"toml++/"}},
    {"stb", {"stb_", "stb/"}},
    {"png", {"png.h"}},
    {"isa-l", {"isa-l/"}},
    {"zlib", {"zlib.h"}},
    {"gemmi", {"gemmi/"}},
    {"boost", {"boost/"}},
    {"glad", {"glad/"}},
    {"EGL", {"EGL/"}},
    {"OSMesa", {"GL/osmesa.h"}},
    {"GLFW", {"GLFW/"}},
    {"fontconfig", {"fontconfig/"}},
    {"CLI11", {"CLI/"}},
    {"json", {"nlohmann/"}},
    {"imgui", {"imgui"}},
    {"pybind11", {"pybind11/"}},
    {"system",
     {"unistd.h", "sys/", "fcntl.h", "poll.h", "sched.h", "spawn.h", "dlfcn.h", "signal.h", "pthread.h", "termios.h", "windows.h",
      "io.h", "malloc.h", "mach-o/"}},
};

bool may_include(std::string_view room, std::string_view what) {
    const Names& names = allowed.at(room);
    return room == what || std::ranges::find(names, what) != names.end();
}

// The room or library that a header between angle brackets belongs to; "std", or "" for one that nobody has allowed.
std::string_view owner(std::string_view header) {
    for (const auto& [library, beginnings] : libraries) {
        if (std::ranges::any_of(beginnings, [&](std::string_view begin) { return header.starts_with(begin); })) return library;
    }
    // Only the C++ standard library's headers have names without an extension.
    return header.find_first_of("./") == std::string_view::npos ? "std" : "";
}

// What a line includes, with its quotes or brackets; "" when it includes nothing.
std::string_view included(std::string_view line) {
    line = trimmed(line);
    if (!line.starts_with('#')) return "";
    line = trimmed(line.substr(1));
    constexpr std::string_view directive = "include";
    if (!line.starts_with(directive)) return "";
    line.remove_prefix(directive.size());
    return trimmed(line.substr(0, line.find("//")));
}

// The end of a quoted #include behind the room.
bool is_file_name(std::string_view text) {
    constexpr std::string_view ending = ".hpp\"";
    if (!text.ends_with(ending) || text.size() == ending.size()) return false;
    text.remove_suffix(ending.size());
    return std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

bool is_room(std::string_view name) { return allowed.contains(name); }

// What is wrong with a line of a file in `room` ("scene", "app"), or "" for a good #include and for any other line.
std::string include_fault(std::string_view room, std::string_view line) {
    const std::string_view what = included(line);
    if (what.empty()) return "";
    if (what.size() > 2 && what.front() == '<' && what.back() == '>') {
        const std::string_view library = owner(what.substr(1, what.size() - 2));
        if (library == "std") return "";
        if (library.empty()) return "a header of an unknown library";
        return may_include(room, library) ? "" : std::string(room) + " may not include " + std::string(library);
    }
    const std::size_t slash = what.find('/');
    if (slash == std::string_view::npos || what.front() != '"' || !is_file_name(what.substr(slash + 1))) {
        return "not of the form \"room/file.hpp\" or <header>";
    }
    const std::string_view other = what.substr(1, slash - 1);
    if (!is_room(other)) return "no such room: " + std::string(other);
    return may_include(room, other) ? "" : std::string(room) + " may not include " + std::string(other);
}

const fs::path source = test::source_file("");

// "scene" for src/scene/sphere.hpp, "app" for app/main.cpp, "panels" for app/panels/help.cpp.
std::string room_of(const fs::path& file) {
    const fs::path path = fs::relative(file, source);
    const std::string second = std::next(path.begin())->string();
    return *path.begin() == "src" || is_room(second) ? second : path.begin()->string();
}

}  // namespace

TEST(IncludeRules, HoldForEveryFile) {
    int checked = 0;
    for (const char* folder : {"src", "app", "python"}) {
        for (const auto& entry : fs::recursive_directory_iterator(source / folder)) {
            const fs::path& file = entry.path();
            if (file.extension() != ".cpp" && file.extension() != ".hpp") continue;
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
        {"base", "#include <sys/wait.h>"},
        {"scene", "  #  include   <glm/vec3.hpp>  // why"},
        {"platform", "#include <GLFW/glfw3.h>"},
        {"app", "#include \"gpu/gl_object.hpp\""},
        {"viewer", "#include \"app/options.hpp\""},
        {"scene", "// #include <unistd.h>"},
        {"scene", "int include;"},
    };
    for (const auto& [room, line] : good) EXPECT_EQ(include_fault(room, line), "") << room << ": " << line;
}

TEST(IncludeRules, ForbidAllElse) {
    const std::vector<std::vector<const char*>> bad = {
        {"base", "#include \"scene/scene.hpp\"", "base may not include scene"},
        {"scene", "#  include <sys/stat.h> // why", "scene may not include system"},
        {"image", "#include <glm/vec3.hpp>", "image may not include glm"},
        {"panels", "#include \"viewer/viewer.hpp\"", "panels may not include viewer"},
        {"scene", "#include \"../base/error.hpp\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include <base/error.hpp>", "a header of an unknown library"},
        {"scene", "#include <math.h>", "a header of an unknown library"},
        {"scene", "#include \"room/file.hpp\"", "no such room: room"},
        {"scene", "#include \"base/error.h\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include HEADER", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include<Eigen/Core>", "a header of an unknown library"},
    };
    for (const auto& line : bad) EXPECT_EQ(include_fault(line[0], line[1]), line[2]) << line[0] << ": " << line[1];
}

}  // namespace sphereview

// Which file may include what: the arrows between the rooms (docs/architecture.md), and every #include against them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "support/folders.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string_view>;

// What a room may include beside itself and the C++ standard library: rooms, libraries, and "system".
const std::map<std::string_view, Names> allowed = {
    {"base", {"system", "zlib", "md"}},
    {"scene", {"base", "glm"}},
    {"camera", {"base", "scene", "glm"}},
    {"edit", {"base", "scene", "glm"}},
    {"formats", {"base", "scene", "glm", "toml++", "gemmi"}},
    {"look", {"base", "scene", "formats", "glm"}},
    {"image", {"base", "stb", "png", "deflate"}},
    {"exact", {"base", "scene", "glm", "boost"}},
    {"light", {"base", "scene", "exact", "glm"}},
    {"shade", {"base", "scene", "image", "exact", "light", "glm"}},
    {"tiles", {"base", "scene", "edit", "exact", "glm"}},
    {"cpu", {"base", "scene", "exact", "tiles", "glm"}},
    {"mistakes", {"base", "scene", "image", "exact", "tiles", "cpu", "glm"}},
    {"gpu", {"base", "scene", "edit", "image", "exact", "light", "shade", "tiles", "glad", "glm"}},
    {"platform", {"base", "glad", "EGL", "OSMesa", "GLFW", "fontconfig", "system"}},
    {"panels", {"base", "scene", "camera", "edit", "look", "exact", "shade", "glm", "imgui"}},
    {"viewer", {"base",  "scene", "camera",   "edit", "formats",  "look",   "image", "exact", "light", "shade",
                "tiles", "cpu",   "mistakes", "gpu",  "platform", "panels", "app",   "glm",   "glad",  "imgui"}},
    {"app",
     {"base", "scene", "camera", "formats", "look", "image", "exact", "light", "shade", "tiles", "cpu", "mistakes", "gpu",
      "platform", "glm", "CLI11"}},
    {"json", {"base", "app"}},  // app/json.cpp alone
    {"python",
     {"base", "scene", "camera", "formats", "image", "exact", "light", "shade", "tiles", "cpu", "gpu", "platform", "app", "glm",
      "pybind11"}},
};

// How the headers of a library begin. "system" is what only some operating systems have.
const std::vector<std::pair<std::string_view, Names>> libraries = {
    {"glm", {"glm/"}},
    {"toml++", {"toml++/"}},
    {"stb", {"stb_", "stb/"}},
    {"png", {"png.h"}},
    {"deflate", {"libdeflate.h"}},
    {"zlib", {"zlib.h"}},
    {"md", {"sha2.h"}},
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
      "io.h", "malloc.h", "mach-o/", "bcrypt.h", "CommonCrypto/"}},
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

bool is_room(std::string_view name) { return allowed.contains(name); }

// What is wrong with a line of a file in `room` ("scene", "app"), or "" for a good #include and for any other line.
std::string include_fault(std::string_view room, const std::string& line) {
    static const std::regex any_include(R"(\s*#\s*include\s*(.*?)\s*(//.*)?)"), header("<(.+)>"),
        file("\"([^/]*)/[a-z0-9_]+\\.hpp\"");
    std::smatch parts;
    if (!std::regex_match(line, parts, any_include)) return "";
    const std::string what = parts[1];
    std::string_view other;
    if (std::regex_match(what, parts, header)) {
        other = owner(what.substr(1, what.size() - 2));
        if (other == "std") return "";
        if (other.empty()) return "a header of an unknown library";
    } else if (std::regex_match(what, parts, file)) {
        other = std::string_view(what).substr(1, static_cast<std::size_t>(parts.length(1)));
        if (!is_room(other)) return "no such room: " + std::string(other);
    } else {
        return "not of the form \"room/file.hpp\" or <header>";
    }
    return may_include(room, other) ? "" : std::string(room) + " may not include " + std::string(other);
}

const fs::path source = test::source_file("");

// "scene" for src/scene/sphere.hpp, "app" for app/main.cpp, "panels" for app/panels/help.cpp.
std::string room_of(const fs::path& file) {
    const fs::path path = fs::relative(file, source);
    if (path == "app/json.cpp") return "json";
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

TEST(IncludeRules, ForbidAllElse) {
    const std::vector<std::vector<const char*>> lines = {
        {"scene", "  #  include   <glm/vec3.hpp>  // why", ""},
        {"scene", "// #include <unistd.h>", ""},
        {"scene", "int include;", ""},
        {"base", "#include \"scene/scene.hpp\"", "base may not include scene"},
        {"scene", "#  include <sys/stat.h> // why", "scene may not include system"},
        {"image", "#include <glm/vec3.hpp>", "image may not include glm"},
        {"panels", "#include \"viewer/viewer.hpp\"", "panels may not include viewer"},
        {"scene", "#include \"../base/error.hpp\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include <base/error.hpp>", "a header of an unknown library"},
        {"scene", "#include \"room/file.hpp\"", "no such room: room"},
        {"scene", "#include \"base/error.h\"", "not of the form \"room/file.hpp\" or <header>"},
        {"scene", "#include<Eigen/Core>", "a header of an unknown library"},
        {"app", "#include <nlohmann/json.hpp>", "app may not include json"},
    };
    for (const auto& line : lines) EXPECT_EQ(include_fault(line[0], line[1]), line[2]) << line[0] << ": " << line[1];
}

}  // namespace sphereview

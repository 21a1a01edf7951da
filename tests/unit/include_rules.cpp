#include "unit/include_rules.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <vector>

namespace sphereview {

namespace {

using Names = std::vector<std::string_view>;

// What a room may include beside itself and the C++ standard library: rooms, libraries, and "system".
const std::map<std::string_view, Names> allowed = {
    {"base", {"system"}},
    {"scene", {"base", "glm", "toml++"}},
    {"image", {"base", "stb", "libdeflate"}},
    {"exact", {"base", "scene", "glm", "boost"}},
    {"shade", {"base", "scene", "image", "exact"}},
    {"cpu", {"base", "scene", "image", "exact", "glm", "omp"}},
    {"gpu", {"base", "scene", "image", "exact", "glad", "glm"}},
    {"platform", {"base", "glad", "EGL", "OSMesa", "GLFW", "system"}},
    {"app", {"base",       "scene", "image", "exact", "shade", "cpu",    "gpu",  "platform", "glm",  "toml++", "stb",
             "libdeflate", "boost", "omp",   "glad",  "EGL",   "OSMesa", "GLFW", "CLI11",    "json", "imgui"}},
};

// How the headers of a library begin. "system" is what only some operating systems have.
const std::vector<std::pair<std::string_view, Names>> libraries = {
    {"glm", {"glm/"}},
    {"toml++", {"toml++/"}},
    {"stb", {"stb_", "stb/"}},
    {"libdeflate", {"libdeflate.h"}},
    {"boost", {"boost/"}},
    {"omp", {"omp.h"}},
    {"glad", {"glad/"}},
    {"EGL", {"EGL/"}},
    {"OSMesa", {"GL/osmesa.h"}},
    {"GLFW", {"GLFW/"}},
    {"CLI11", {"CLI/"}},
    {"json", {"nlohmann/"}},
    {"imgui", {"imgui"}},
    {"system",
     {"unistd.h", "sys/", "fcntl.h", "poll.h", "spawn.h", "dlfcn.h", "signal.h", "pthread.h", "termios.h", "windows.h", "io.h",
      "mach-o/"}},
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

}  // namespace

bool is_room(std::string_view name) { return allowed.contains(name); }

std::string include_fault(std::string_view room, const std::string& line) {
    static const std::regex include(R"(\s*#\s*include\b\s*(.*?)\s*(//.*)?)");
    static const std::regex angle("<([^>]+)>");
    static const std::regex quoted(R"re("([a-z]+)/[a-z0-9_]+\.hpp")re");
    std::smatch match;
    if (!std::regex_match(line, match, include)) return "";
    const std::string what = match[1];
    if (std::regex_match(what, match, angle)) {
        const std::string_view library = owner(match[1].str());
        if (library == "std") return "";
        if (library.empty()) return "a header of an unknown library";
        return may_include(room, library) ? "" : std::string(room) + " may not include " + std::string(library);
    }
    if (!std::regex_match(what, match, quoted)) return "not of the form \"room/file.hpp\" or <header>";
    const std::string other = match[1];
    if (!is_room(other)) return "no such room: " + other;
    return may_include(room, other) ? "" : std::string(room) + " may not include " + other;
}

}  // namespace sphereview

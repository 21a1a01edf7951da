#include "unit/include_rules.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace sphereview {

namespace {

using Names = std::vector<std::string_view>;

// What a room may include beside itself and the C++ standard library: rooms, libraries, and "system".
const std::map<std::string_view, Names> allowed = {
    {"base", {"system", "zlib"}},
    {"scene", {"base", "glm"}},
    {"camera", {"base", "scene", "glm"}},
    {"edit", {"base", "scene", "glm"}},
    {"formats", {"base", "scene", "glm", "toml++", "gemmi"}},
    {"image", {"base", "stb", "libdeflate"}},
    {"exact", {"base", "scene", "glm", "boost"}},
    {"shade", {"base", "scene", "image", "exact", "glm"}},
    {"tiles", {"base", "scene", "edit", "exact", "glm"}},
    {"cpu", {"base", "scene", "exact", "tiles", "glm"}},
    {"gpu", {"base", "scene", "edit", "image", "exact", "shade", "tiles", "glad", "glm"}},
    {"platform", {"base", "glad", "EGL", "OSMesa", "GLFW", "fontconfig", "system"}},
    {"panels", {"base", "scene", "camera", "edit", "exact", "shade", "glm", "imgui"}},
    {"viewer",
     {"base", "scene", "camera", "edit", "formats", "image", "exact", "shade", "tiles", "cpu", "gpu", "platform", "panels", "app",
      "glm", "glad", "json", "imgui"}},
    {"app", {"base", "scene",  "camera", "edit",       "formats", "image", "exact", "shade",  "tiles", "cpu",   "gpu", "platform",
             "glm",  "toml++", "stb",    "libdeflate", "boost",   "glad",  "EGL",   "OSMesa", "GLFW",  "CLI11", "json"}},
};

// How the headers of a library begin. "system" is what only some operating systems have.
const std::vector<std::pair<std::string_view, Names>> libraries = {
    {"glm", {"glm/"}},
    {"toml++", {"toml++/"}},
    {"stb", {"stb_", "stb/"}},
    {"libdeflate", {"libdeflate.h"}},
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

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
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

}  // namespace

bool is_room(std::string_view name) { return allowed.contains(name); }

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

}  // namespace sphereview

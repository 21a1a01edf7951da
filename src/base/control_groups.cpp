#include "base/control_groups.hpp"

#ifdef __linux__
#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#endif

namespace sphereview {

#ifdef __linux__

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

std::uint64_t left_of(std::uint64_t whole, std::uint64_t part) { return whole - std::min(whole, part); }

// How a version of control groups calls what it says of memory, below /sys/fs/cgroup.
struct GroupFiles {
    const char* folder;
    const char* limit;
    const char* used;
    std::array<const char*, 2> dropped;  // pages of files in "stat", which the system drops when memory is wanted
};
constexpr GroupFiles version_1 = {"/memory", "limit_in_bytes", "usage_in_bytes", {"total_inactive_file", "total_active_file"}};
constexpr GroupFiles version_2 = {"", "max", "current", {"inactive_file", "active_file"}};

// The least that is left in the group at `path` and in those around it.
std::uint64_t left_in_group(const std::string& root, std::string path, const GroupFiles& files) {
    for (std::uint64_t least = no_limit;; path.resize(std::min(path.rfind('/'), path.size() - 1))) {
        const std::string folder = root + "/sys/fs/cgroup" + files.folder + path + "/memory.";
        std::uint64_t used = number_in_file(folder + files.used).value_or(0);
        for (const char* pages : files.dropped) used = left_of(used, number_in_file(folder + "stat", pages).value_or(0));
        if (const auto limit = number_in_file(folder + files.limit)) least = std::min(least, left_of(*limit, used));
        if (path.empty()) return least;
    }
}

}  // namespace

std::optional<std::uint64_t> number_in_file(const std::string& path, std::string_view key) {
    std::ifstream file(path);
    std::string word;
    while (!key.empty() && file >> word && word != key) file.ignore(1 << 16, '\n');
    std::uint64_t number = 0;
    if (!(file >> number)) return std::nullopt;
    return number;
}

std::optional<std::uint64_t> memory_left_in_groups(const std::string& root) {
    std::uint64_t least = no_limit;
    std::ifstream groups(root + "/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {  // "4:memory:/a/b"; of version 2 "0::/a/b"
        const std::size_t first = std::min(line.find(':'), line.size());
        const std::size_t second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        const std::string path = line.substr(second + 1);
        if (controllers == ",,") least = std::min(least, left_in_group(root, path, version_2));
        if (controllers.find(",memory,") != std::string::npos) least = std::min(least, left_in_group(root, path, version_1));
    }
    return least != no_limit ? std::optional(least) : std::nullopt;
}

#else

std::optional<std::uint64_t> number_in_file(const std::string&, std::string_view) { return std::nullopt; }

std::optional<std::uint64_t> memory_left_in_groups(const std::string&) { return std::nullopt; }

#endif

}  // namespace sphereview

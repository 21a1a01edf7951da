#include "base/available_memory.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <string_view>
#endif

namespace sphereview {

#ifdef __linux__

namespace {

using Bytes = std::optional<std::uint64_t>;

// The number in a file, or behind `key` at the start of one of its lines; nothing for other words ("max") and missing files.
Bytes number_in(const std::string& path, std::string_view key = {}) {
    std::ifstream file(path);
    std::string word;
    while (!key.empty() && file >> word && word != key) file.ignore(1 << 16, '\n');
    std::uint64_t number = 0;
    if (!(file >> number)) return std::nullopt;
    return number;
}

Bytes smaller(Bytes a, Bytes b) { return a && b ? std::min(*a, *b) : a ? a : b; }

std::uint64_t difference(std::uint64_t whole, std::uint64_t part) { return whole - std::min(whole, part); }

// How one version of control groups spells things.
struct Groups {
    std::string_view line;  // how the group's line in /proc/self/cgroup begins, behind its number
    std::string mount;
    std::string limit;
    std::string used;
    std::array<std::string_view, 2> file_pages;  // parts of `used` that the system drops when memory is wanted
};

const std::array<Groups, 2> versions = {{
    {"::", "/sys/fs/cgroup", "memory.max", "memory.current", {"inactive_file", "active_file"}},
    {":memory:",
     "/sys/fs/cgroup/memory",
     "memory.limit_in_bytes",
     "memory.usage_in_bytes",
     {"total_inactive_file", "total_active_file"}},
}};

Bytes left_in_group(const Groups& groups, const std::string& folder) {
    const Bytes limit = number_in(folder + "/" + groups.limit);
    const Bytes used = number_in(folder + "/" + groups.used);
    if (!limit || !used) return std::nullopt;
    std::uint64_t kept = *used;
    for (const std::string_view key : groups.file_pages) {
        kept = difference(kept, number_in(folder + "/memory.stat", key).value_or(0));
    }
    return difference(*limit, kept);
}

// The least that is left in this process's group and those around it.
Bytes left_in_groups() {
    Bytes least;
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const std::string_view entry = std::string_view(line).substr(std::min(line.find(':'), line.size()));
        for (const Groups& groups : versions) {
            if (!entry.starts_with(groups.line)) continue;
            std::string path(entry.substr(groups.line.size()));
            while (true) {
                least = smaller(least, left_in_group(groups, groups.mount + path));
                if (path.empty()) break;
                path.resize(std::min(path.rfind('/'), path.size() - 1));
            }
        }
    }
    return least;
}

Bytes left_of_address_space() {
    rlimit limit{};
    const Bytes pages = number_in("/proc/self/statm");
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !pages) return std::nullopt;
    return difference(limit.rlim_cur, *pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

Bytes available_memory() {
    Bytes least = number_in("/proc/meminfo", "MemAvailable:");
    if (least) *least *= 1024;
    return smaller(least, smaller(left_in_groups(), left_of_address_space()));
}

#else

std::optional<std::uint64_t> available_memory() { return std::nullopt; }

#endif

void require_memory(std::uint64_t bytes, const std::string& what) {
    constexpr std::uint64_t any_machine_has = std::uint64_t{1} << 25;
    if (bytes <= any_machine_has) return;
    const auto available = available_memory();
    if (!available || bytes <= *available) return;
    throw MemoryError(what + " " + in_bytes(bytes) + " of memory, " + in_bytes(*available) + " are available");
}

std::string in_bytes(std::uint64_t bytes) {
    constexpr double mega = 1e6;
    constexpr double giga = 1e9;
    const auto value = static_cast<double>(bytes);
    return value < giga ? fixed(value / mega, 0) + " MB" : fixed(value / giga, 1) + " GB";
}

}  // namespace sphereview

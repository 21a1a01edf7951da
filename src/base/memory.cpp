#include "base/memory.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#ifdef __linux__
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#endif

namespace sphereview {

#ifdef __linux__

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t difference(std::uint64_t whole, std::uint64_t part) { return whole - std::min(whole, part); }

// The number in a file, or behind `key` at the start of one of its lines; nothing for other words ("max") and missing files.
std::optional<std::uint64_t> number_in_file(const std::string& path, std::string_view key = {}) {
    std::ifstream file(path);
    std::string word;
    while (!key.empty() && file >> word && word != key) file.ignore(1 << 16, '\n');
    std::uint64_t number = 0;
    if (!(file >> number)) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::uint64_t> memory_left_in_groups(const std::string& root) {
    std::ifstream groups(root + "/proc/self/cgroup");
    std::string path;
    while (std::getline(groups, path) && !path.starts_with("0::")) {
    }
    if (!groups) return std::nullopt;
    path.erase(0, 3);  // "/a/b" is left
    // The group and those around it.
    for (std::uint64_t least = unlimited;; path.resize(std::min(path.rfind('/'), path.size() - 1))) {
        const std::string files = root + "/sys/fs/cgroup" + path + "/memory.";
        std::uint64_t used = number_in_file(files + "current").value_or(0);
        // Pages of files do not count: the system drops them when memory is needed.
        for (const char* pages : {"inactive_file", "active_file"}) {
            used = difference(used, number_in_file(files + "stat", pages).value_or(0));
        }
        if (const auto limit = number_in_file(files + "max")) least = std::min(least, difference(*limit, used));
        if (path.empty()) return least != unlimited ? std::optional(least) : std::nullopt;
    }
}

std::optional<std::uint64_t> address_space_left() {
    rlimit limit{};
    const auto pages = number_in_file("/proc/self/statm");
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !pages) return std::nullopt;
    return difference(limit.rlim_cur, *pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

std::optional<std::uint64_t> available_memory() {
    const auto free = number_in_file("/proc/meminfo", "MemAvailable:");
    const std::uint64_t least = std::min(
        {free ? *free * 1024 : unlimited, memory_left_in_groups().value_or(unlimited), address_space_left().value_or(unlimited)});
    return least != unlimited ? std::optional(least) : std::nullopt;
}

void prefer_large_pages(void* memory, std::size_t bytes) {
    constexpr std::uintptr_t large = std::uintptr_t{1} << 21;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + large - 1) / large * large;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / large * large;
    // What it returns does not matter: it is a wish.
    if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

#else

void prefer_large_pages(void*, std::size_t) {}

std::optional<std::uint64_t> memory_left_in_groups(const std::string&) { return std::nullopt; }

std::optional<std::uint64_t> address_space_left() { return std::nullopt; }

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

void return_large_blocks() {
#ifdef __GLIBC__
    constexpr int large = 4 << 20;  // bytes; smaller blocks are used again soon, and new pages cost time
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
#endif
}

}  // namespace sphereview

#include "base/file_state.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#ifndef _WIN32
#include <sys/stat.h>
#endif

namespace sphereview {

namespace fs = std::filesystem;

namespace {

// Nothing for a folder or where nothing is.
std::optional<FileState> state_of(const fs::path& file) {
#ifdef _WIN32
    std::error_code error;
    if (!fs::exists(file, error) || fs::is_directory(file, error)) return {};
    FileState state;
    state.size = fs::file_size(file, error);
    state.time = fs::last_write_time(file, error).time_since_epoch().count();
    return state;
#else
    struct stat status {};
    if (stat(file.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return {};
#ifdef __APPLE__
    const timespec time = status.st_mtimespec;
#else
    const timespec time = status.st_mtim;
#endif
    constexpr std::int64_t second = 1'000'000'000;
    return FileState{static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino),
                     static_cast<std::uint64_t>(status.st_size), std::int64_t{time.tv_sec} * second + time.tv_nsec};
#endif
}

}  // namespace

FileStates file_states(const std::string& path) {
    FileStates states;
    std::error_code error;
    if (const auto state = state_of(path)) {
        states.emplace("", *state);
    } else {
        for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
            if (const auto file = state_of(entry->path())) states.emplace(entry->path().filename().string(), *file);
        }
    }
    return states;
}

bool has_news(const FileStates& before, const FileStates& after) {
    return std::ranges::any_of(after, [&](const auto& file) {
        const auto old = before.find(file.first);
        return old == before.end() || old->second != file.second;
    });
}

}  // namespace sphereview

#include "base/file_watcher.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/path.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr auto interval = std::chrono::milliseconds(250);

// Nothing for a folder or where nothing is.
std::optional<FileState> state_of(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error) || fs::is_directory(file, error)) return {};
    FileState state{fs::canonical(file, error), 0, fs::last_write_time(file, error)};
    if (fs::is_regular_file(file, error)) state.size = fs::file_size(file, error);
    return state;
}

}  // namespace

FileStates file_states(const std::string& path) {
    FileStates states;
    std::error_code error;
    if (const auto state = state_of(path_from(path))) {
        states.emplace("", *state);
    } else {
        for (fs::directory_iterator entry(path_from(path), error), end; !error && entry != end; entry.increment(error)) {
            if (const auto file = state_of(entry->path())) states.emplace(text_from(entry->path().filename()), *file);
        }
    }
    return states;
}

void FileWatcher::watch(const std::vector<std::string>& paths) {
    std::vector<Watched> before = std::exchange(watched_, {});
    for (const std::string& path : paths) {
        if (path.empty()) continue;
        const auto old = std::ranges::find(before, path, &Watched::path);
        watched_.push_back(old != before.end() ? std::move(*old) : Watched{path, file_states(path)});
    }
}

std::vector<std::string> FileWatcher::look(Time now) {
    std::vector<std::string> changed;
    if (now < next_look_) return changed;
    next_look_ = now + interval;
    for (Watched& watched : watched_) {
        FileStates states = file_states(watched.path);
        if (states != watched.last) {
            watched.unsettled = true;
            watched.last = std::move(states);
        } else if (std::exchange(watched.unsettled, false)) {
            changed.push_back(watched.path);
        }
    }
    return changed;
}

std::optional<FileWatcher::Time> FileWatcher::next_look() const {
    return watched_.empty() ? std::nullopt : std::optional(next_look_);
}

}  // namespace sphereview

#include "base/file_watcher.hpp"

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

#include "base/path.hpp"

namespace sphereview {

namespace fs = std::filesystem;

namespace {

constexpr auto interval = std::chrono::milliseconds(250);

// Nothing where no regular file is.
std::optional<FileState> state_of(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return {};
    fs::path canonical = fs::canonical(file, error);
    if (error == std::errc::not_enough_memory) throw std::bad_alloc();  // else the file would seem another one
    return FileState{std::move(canonical), fs::file_size(file, error), fs::last_write_time(file, error)};
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
    std::vector<std::string> wanted = paths;
    std::erase(wanted, "");
    if (std::ranges::equal(wanted, watched_, {}, {}, &Watched::path)) return;
    round_.reset();  // it is of other files
    std::vector<Watched> before = std::exchange(watched_, {});
    for (const std::string& path : wanted) {
        const auto old = std::ranges::find(before, path, &Watched::path);
        watched_.push_back(old != before.end() ? std::move(*old) : Watched{path, states_of_(path)});
    }
}

std::vector<std::string> FileWatcher::look(Time now) {
    if (now < next_look_ || watched_.empty()) return {};
    next_look_ = now + interval;
    if (!round_) begin_round();
    return round_->job.wait_for(patience_) ? end_round() : std::vector<std::string>();
}

void FileWatcher::begin_round() {
    std::vector<std::string> paths;
    for (const Watched& watched : watched_) paths.push_back(watched.path);
    const auto states = std::make_shared<std::vector<FileStates>>();
    round_.emplace(Round{states, BackgroundJob(
                                     [states, paths = std::move(paths), states_of = states_of_](WorkControl&) {
                                         for (const std::string& path : paths) states->push_back(states_of(path));
                                     },
                                     WorkPriority::usual)});
}

std::vector<std::string> FileWatcher::end_round() {
    const Round round = std::move(*round_);
    round_.reset();
    std::vector<std::string> changed;
    if (round.states->size() != watched_.size()) return changed;  // memory or threads ran out: the next look may succeed
    for (std::size_t i = 0; i < watched_.size(); ++i) {
        Watched& watched = watched_[i];
        FileStates& states = (*round.states)[i];
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

// Notices changes of files on disk by looking from time to time: notifications would be other code on each system.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/background_job.hpp"

namespace sphereview {

// Shows that a file was written or replaced, without reading it.
struct FileState {
    std::filesystem::path target;  // where symbolic links lead
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;  // of the last write

    bool operator==(const FileState&) const = default;
};

// The state of a regular file, under the name "", or of all regular files in a folder. Empty for others: a FIFO or a device could
// not be read again, and opening it might wait for ever.
using FileStates = std::map<std::string, FileState>;

FileStates file_states(const std::string& path);

class FileWatcher {
public:
    using Time = std::chrono::steady_clock::time_point;
    using StatesOf = std::function<FileStates(const std::string& path)>;

    // A job asks the disks. While one hangs, each look takes `patience` and reports nothing.
    explicit FileWatcher(std::chrono::milliseconds patience = std::chrono::milliseconds(2), StatesOf states_of = file_states)
        : patience_(patience), states_of_(std::move(states_of)) {}

    // Replaces the files to watch. "" means no file, and a folder all files in it.
    void watch(const std::vector<std::string>& paths);

    // The files that were written, replaced, created or deleted, and then unchanged from one look to the next: a half-written file,
    // or one that is gone for a moment, is not reported. Looks at most four times a second. The caller finds out whether the
    // content differs.
    std::vector<std::string> look(Time now);

    // When to call look(); nothing while no file is watched.
    std::optional<Time> next_look() const;

private:
    struct Watched {
        std::string path;
        FileStates last;
        bool unsettled = false;  // changed at the last look
    };
    // One look at all files that were watched at its beginning.
    struct Round {
        std::shared_ptr<std::vector<FileStates>> states;
        BackgroundJob job;
    };

    void begin_round();
    std::vector<std::string> end_round();

    std::chrono::milliseconds patience_;
    StatesOf states_of_;
    std::vector<Watched> watched_;
    std::optional<Round> round_;
    Time next_look_;
};

}  // namespace sphereview

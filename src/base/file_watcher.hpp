// Noticing that files change on disk, by looking from time to time. Notices from the system would be other code on each system.
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

// What shows that a file was written or replaced without reading it.
struct FileState {
    std::filesystem::path target;  // what symbolic links lead to
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;  // of the last write

    bool operator==(const FileState&) const = default;
};

// Of a regular file: itself, under the name "". Of a folder: all regular files in it. Empty when there is none: a FIFO or a device
// holds nothing that could be read again, and whoever opened it might wait for good.
using FileStates = std::map<std::string, FileState>;

FileStates file_states(const std::string& path);

class FileWatcher {
public:
    using Time = std::chrono::steady_clock::time_point;
    using StatesOf = std::function<FileStates(const std::string& path)>;

    // Disks are asked beside the caller: where one hangs, each look takes `patience` and tells nothing until the disk answers.
    explicit FileWatcher(std::chrono::milliseconds patience = std::chrono::milliseconds(2), StatesOf states_of = file_states)
        : patience_(patience), states_of_(std::move(states_of)) {}

    // The files to watch from now on, instead of those before; "" stands for none. A folder stands for all files in it.
    void watch(const std::vector<std::string>& paths);

    // Which of them were written, replaced, created or deleted, and then left alone from one look to the next: a file that is half
    // written is not told of, nor one that is gone for a moment. Looks at most four times a second. Whether the content is another
    // is for the caller to see.
    std::vector<std::string> look(Time now);

    // When to call look(); nothing while there is nothing to watch.
    std::optional<Time> next_look() const;

private:
    struct Watched {
        std::string path;
        FileStates last;
        bool unsettled = false;  // it had changed when it was last looked at
    };
    // One look at all that was watched when it began.
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

// Noticing that files change on disk, by looking from time to time. Notices from the system would be other code on each system.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sphereview {

// What shows that a file was written or replaced without reading it.
struct FileState {
    std::filesystem::path target;  // what symbolic links lead to
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;  // of the last write

    bool operator==(const FileState&) const = default;
};

// Of a file: itself, under the name "". Of a folder: all files in it. Empty when there is none.
using FileStates = std::map<std::string, FileState>;

FileStates file_states(const std::string& path);

class FileWatcher {
public:
    using Time = std::chrono::steady_clock::time_point;

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
    std::vector<Watched> watched_;
    Time next_look_;
};

}  // namespace sphereview

// What shows that a file was written without reading it.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>

namespace sphereview {

struct FileState {
    std::uint64_t device = 0;  // with `number`, the file's identity; 0 where the system has none
    std::uint64_t number = 0;
    std::uint64_t size = 0;
    std::int64_t time = 0;  // of the last write, in the system's finest unit

    bool operator==(const FileState&) const = default;
};

// Of a file: itself, under the name "". Of a folder: all files in it. Empty when there is none.
using FileStates = std::map<std::string, FileState>;

// Of what `path` leads to, through symbolic links.
FileStates file_states(const std::string& path);

// Whether `after` has a file that `before` has not, or has otherwise.
bool has_news(const FileStates& before, const FileStates& after);

}  // namespace sphereview

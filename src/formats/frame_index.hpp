// Where the frames of a large file stand, kept between runs: so its last frame is reached as quickly as its first. Indexes lie in
// the user's folder for such things (base/user_folders.hpp), a file each, few and of a limited size. They save time and no more:
// one that is damaged, or of a file that has changed, counts for nothing, and where none can be written there is none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/gzip_places.hpp"
#include "base/text.hpp"

namespace sphereview {

// A frame in a text.
struct FramePlace {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    TextPosition origin{};                 // of its first character
    std::size_t numbers_behind_first = 0;  // PartOfFile
};

struct FrameIndex {
    std::vector<FramePlace> frames{};  // from the first one on, without a gap
    // Behind the last of them.
    TextPosition end_position{};
    std::size_t numbers_behind_first = 0;
    GzipPlaces packed{};  // of a packed file
};

// What tells whether a file is still the one that it was.
struct FileStamp {
    std::string file{};  // as file_identity() has it
    std::string format{};
    std::uint64_t size = 0;
    std::int64_t time = 0;  // of the last change, in the file system's units
    std::string sum{};      // SHA-256 of some bytes at both ends

    bool operator==(const FileStamp&) const = default;
};

// Nothing where it is no regular file, or one that cannot be looked at.
std::optional<FileStamp> stamp_of(const std::string& path, std::string_view format);

// What was kept of the file; nothing where there is none of use.
std::optional<FrameIndex> read_frame_index(const FileStamp& stamp);

// Keeps the index instead of what was kept of the file, whole or not at all, and removes the oldest others beyond the limits. Not
// where it is too large, or where the file was changed a moment ago, so that a further change would not show.
void keep_frame_index(const FileStamp& stamp, const FrameIndex& index) noexcept;

void forget_frame_index(const FileStamp& stamp) noexcept;

}  // namespace sphereview

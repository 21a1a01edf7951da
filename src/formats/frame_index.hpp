// Keeps the places of a large file's frames between runs, so its last frame is reached as quickly as its first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/gzip_places.hpp"
#include "base/text.hpp"
#include "formats/kept_findings.hpp"

namespace sphereview {

// A frame in a text.
struct FramePlace {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    TextPosition origin{};     // of its first character
    std::size_t of_first = 0;  // PartOfFile
};

struct FrameIndex {
    std::vector<FramePlace> frames{};  // from the first one on, without a gap
    // Behind the last frame.
    TextPosition end_position{};
    std::size_t of_first = 0;
    GzipPlaces packed{};  // of a packed file
};

// The file's kept index; nothing if there is no valid one.
std::optional<FrameIndex> read_frame_index(const FileStamp& stamp);

// Keeps the index, as keep_finding().
void keep_frame_index(const FileStamp& stamp, const FrameIndex& index) noexcept;

void forget_frame_index(const FileStamp& stamp) noexcept;

}  // namespace sphereview

#include "formats/frame_index.hpp"

#include <utility>

namespace sphereview {

namespace {

constexpr FindingKind indexes{".frames", std::size_t{1} << 25, 64, std::uint64_t{1} << 28};

// Frames follow each other, so that their lengths say where they are.
std::string packed(const FrameIndex& index) {
    KeptWriter to;
    to.number(index.frames.size());
    to.number(index.frames.front().begin);
    std::size_t line = 0;
    for (const FramePlace& place : index.frames) {
        to.number(place.end - place.begin);
        to.number(place.origin.line - line);
        to.number(place.origin.column);
        to.number(place.of_first);
        line = place.origin.line;
    }
    to.number(index.end_position.line);
    to.number(index.end_position.column);
    to.number(index.of_first);
    to.number(index.packed.spacing());
    to.number(index.packed.all().size());
    for (const GzipPlace& place : index.packed.all()) {
        to.number(place.packed);
        to.number(place.unpacked);
        to.number(place.bits);
        to.number(place.begins_member ? 1 : 0);
        to.text(place.text);
    }
    return to.bytes();
}

FrameIndex read_index(KeptReader& from) {
    FrameIndex index;
    index.frames.resize(from.count());
    std::uint64_t begin = from.number();
    std::size_t line = 0;
    for (FramePlace& place : index.frames) {
        place.begin = begin;
        place.end = begin += from.number();
        place.origin.line = line += static_cast<std::size_t>(from.number());
        place.origin.column = static_cast<std::size_t>(from.number());
        place.of_first = static_cast<std::size_t>(from.number());
    }
    index.end_position.line = static_cast<std::size_t>(from.number());
    index.end_position.column = static_cast<std::size_t>(from.number());
    index.of_first = static_cast<std::size_t>(from.number());
    index.packed = GzipPlaces(from.number());
    for (std::size_t left = from.count(); left > 0; --left) {
        GzipPlace place;
        place.packed = from.number();
        place.unpacked = from.number();
        place.bits = static_cast<unsigned>(from.number());
        place.begins_member = from.number() != 0;
        place.text = from.text();
        index.packed.add(std::move(place));
    }
    return index;
}

}  // namespace

std::optional<FrameIndex> read_frame_index(const FileStamp& stamp) {
    try {
        const std::optional<std::string> kept = read_finding(indexes, stamp);
        if (!kept) return std::nullopt;
        KeptReader reader(*kept);
        FrameIndex index = read_index(reader);
        return index.frames.empty() ? std::nullopt : std::optional(std::move(index));
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void keep_frame_index(const FileStamp& stamp, const FrameIndex& index) noexcept {
    try {
        if (!index.frames.empty()) keep_finding(indexes, stamp, "", packed(index));
    } catch (const std::exception&) {
        // The memory does not suffice: nothing is kept.
    }
}

void forget_frame_index(const FileStamp& stamp) noexcept { forget_finding(indexes, stamp); }

}  // namespace sphereview

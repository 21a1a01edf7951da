// Reads the frames of a file one after the other: a trajectory is read in one pass and is never in memory as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_file.hpp"
#include "formats/frame_index.hpp"
#include "formats/scene_format.hpp"
#include "formats/sphere_data.hpp"

namespace sphereview {

// Reads the beginning of a stream, and tells the format by that. Throws InputError.
const SceneFormat& format_of_stream(InputStream& stream, const DataOptions& options);

// For formats that step over frames (scene_format.hpp) only a part of the text is in memory, and the place of each passed frame is
// remembered; for other formats, and pipes, all that was read is in memory. A packed file is unpacked from the last remembered
// place before the frame; there is one every few megabytes (base/gzip_places.hpp).
class FrameReader {
public:
    // Opens `path`, or standard input for "-", and tells its format. Ignores `frame` and `part` of `options`. Throws InputError.
    FrameReader(const std::string& path, DataOptions options);
    // Keeps the places of frames for later runs (frame_index.hpp), if finding them took long.
    ~FrameReader();
    FrameReader(FrameReader&&) noexcept = default;
    FrameReader& operator=(FrameReader&&) = delete;

    const std::string& name() const { return stream_.name(); }
    const SceneFormat& format() const { return format_; }
    // A long file's stamp, for kept findings (kept_findings.hpp).
    const std::optional<FileStamp>& stamp() const { return stamp_; }
    // From now on gives points this radius, instead of one made of each frame's distances.
    void set_radius_of_points(double radius) { options_.radius_of_points = radius; }
    // Calls `watcher` now and then with the passed part of the file, 0..1; not for pipes.
    void watch(std::function<void(double)> watcher) { watcher_ = std::move(watcher); }

    // The number of frames, counted up to `enough`. A fault behind the first frame ends the file there. Throws InputError.
    std::int64_t count(std::int64_t enough = most_frames);
    // That fault, once frames up to it were counted; "" if none was met.
    const std::string& fault() const { return fault_; }
    // Whether more text follows that fault, so that the file is damaged and not only cut off; also if a frame up to there is cut
    // off and others follow.
    bool is_damaged() const { return is_damaged_; }

    // The frame's spheres. Throws InputError, also if the file has no such frame, and MemoryError.
    SphereData read(std::int64_t frame);

    static constexpr std::int64_t most_frames = std::int64_t{1} << 62;

private:
    std::optional<std::size_t> length_of_next(PartOfFile& part);
    std::optional<bool> loses_frames(std::string_view text, std::size_t offset, PartOfFile part);
    std::string_view rest_of_text();
    bool find_next();
    std::optional<double> part_passed() const;
    void begin_at_the_beginning();
    void note_stamp();
    void take_index();
    void keep_index() noexcept;
    bool is_a_frame(std::size_t number);
    void go_to(std::uint64_t offset);
    std::string_view head_for(std::size_t number, std::size_t of_first);
    std::string_view text_from(std::uint64_t offset) const;
    bool holds_all() const { return format_.step_over == nullptr || !stream_.is_regular(); }
    void count_in_whole_file();
    SphereData read_of_whole_file(DataOptions options);

    std::string path_;
    DataOptions options_;
    InputStream stream_;
    SceneFormat format_{};
    std::function<void(double)> watcher_{};
    std::uint64_t window_ = 0;  // the text's place where the stream's window begins
    std::uint64_t end_ = 0;     // of the frames found
    TextPosition end_position_{};
    std::size_t of_first_ = 0;
    std::vector<FramePlace> places_{};
    std::size_t head_of_ = 0;  // the PartOfFile::of_first of head_
    std::string head_{};
    std::optional<FileStamp> stamp_{};  // if an index may be kept
    std::size_t from_index_ = 0;        // places
    std::uint64_t known_end_ = 0;       // the end of the frames that the kept index has, or would have
    bool is_whole_ = false;             // the single frame is the whole text
    bool found_all_ = false;
    std::string fault_{};
    bool is_damaged_ = false;
    std::optional<std::size_t> end_marks_{};  // their bytes, once the text's end was read
    // For a format that is only read whole: the number of frames, and the last one that was read, with the place behind it.
    std::optional<std::int64_t> frames_{};
    std::optional<std::int64_t> cut_frame_{};
    std::int64_t last_frame_ = 0;
    std::size_t behind_last_ = 0;
};

}  // namespace sphereview

// Reads and counts frames of a file beside the window's loop, before they are shown.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/load_scene.hpp"
#include "base/background_job.hpp"

namespace sphereview {

class FrameReader;

struct PassedFrame {
    std::int64_t number = 0;
    LoadedScene loaded{};
};

class FramesAhead {
public:
    // No frame is read ahead beyond about so many bytes.
    static constexpr std::size_t usual_most_bytes = std::size_t{64} << 20U;
    static constexpr std::size_t most_frames = 24;

    // Opens `path` beside the caller. `options`: for each frame, without its number.
    FramesAhead(std::string path, LoadOptions options, std::size_t most_bytes = usual_most_bytes);
    // Ends the work, and waits for nothing.
    ~FramesAhead();
    FramesAhead(const FramesAhead&) = delete;
    FramesAhead& operator=(const FramesAhead&) = delete;

    // Replaces the frames to read: the first in any case, the others as far as there is room. Forgets other frames.
    void want(std::vector<std::int64_t> frames);
    // A new look forgets all frames that were read.
    void set_look(const LookOptions& look);

    // Gives a frame away; nothing if it is not read yet.
    std::optional<LoadedScene> take(std::int64_t frame);
    // The latest frame that was wanted first when its reading began, but not now: it shows where a dragged handle passes.
    std::optional<PassedFrame> take_passed();
    // The time of a frame that was read, in the file's unit; nothing where the file has none.
    std::optional<double> time_of(std::int64_t frame) const;
    // Why a wanted frame cannot be read.
    std::optional<std::string> fault_of(std::int64_t frame) const;
    // Whether the file cannot be read at all.
    bool has_no_file() const;
    // Waits until a wanted frame is read or has a fault.
    void wait_for(std::int64_t frame) const;

    struct Count {
        std::int64_t frames = 0;  // known so far
        bool all = false;         // no more will come
        double part = 0.0;        // the part of the file that was looked through, 0..1
        std::string fault{};      // the fault behind the last frame, if any
    };
    Count count() const;

private:
    struct Shared;
    struct Task;
    static void work(Shared& shared, const std::string& path, const LoadOptions& options);
    static void read_one(Shared& shared, FrameReader& reader, LoadOptions options, const Task& task);
    static void count_on(Shared& shared, FrameReader& reader);

    std::shared_ptr<Shared> shared_;
    BackgroundJob job_;
};

}  // namespace sphereview
